// A beam of light and parallel rays.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }

light_source { <-1.5, 4, -2> rgb <1, 0.6, 0.4> cylinder point_at <-0.8, 0, 0> radius 0.7 falloff 0.9 tightness 2 }
light_source { <5, 4, -2> rgb <0.2, 0.3, 0.6> parallel point_at <0, 0, 0> }
plane { y, -0.6 pigment { rgb 0.9 } }
sphere { <0, 0.1, 0>, 0.5 pigment { rgb <0.9, 0.7, 0.5> } }
