// Cone, falloff and tightness.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }

light_source { <-3, 4, -2> rgb <1.5, 0.6, 0.4> spotlight point_at <-0.8, 0, 0> radius 10 falloff 18 }
light_source { <3, 4, -2> rgb <0.4, 0.6, 1.5> spotlight point_at <0.8, 0, 0> radius 4 falloff 25 tightness 10 }
plane { y, -0.6 pigment { rgb 0.9 } }
sphere { <0, 0.1, 0>, 0.5 pigment { rgb <0.9, 0.7, 0.5> } }
