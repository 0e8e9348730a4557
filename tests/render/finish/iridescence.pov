// irid on diffuse light and on reflections.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

sphere { <-1, 0.3, 0>, 0.8 pigment { rgb 0.6 } finish { irid { 0.5 thickness 0.6 } } }
sphere { <1, 0.3, 0>, 0.8 pigment { rgb 0.2 } finish { reflection 0.5 irid { 0.4 thickness 1.5 } specular 0.5 } }
