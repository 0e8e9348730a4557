// Two facing mirrors and a ball between them: reflections down to max_trace_level.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

box { <-2, -0.6, -1>, <-1.9, 2, 3> pigment { rgb 0.1 } finish { reflection 0.85 } }
box { <1.9, -0.6, -1>, <2, 2, 3> pigment { rgb 0.1 } finish { reflection 0.85 } }
sphere { <0, 0.1, 0.5>, 0.7 pigment { rgb <0.9, 0.4, 0.2> } finish { phong 0.8 } }
