// A light with a surface.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, -6> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <5, 8, -6> rgb 1 area_light 2.5*x, 2.5*y, 9, 9 }
plane { y, 0 pigment { rgb 0.8 } }
#for (I, -2, 2) cylinder { <I, 0, 0.3*I>, <I, 1.6, 0.3*I>, 0.18 pigment { rgb <0.4, 0.5, 0.8> } } #end
sphere { <0.5, 0.5, -1.5>, 0.5 pigment { rgb <0.9, 0.5, 0.3> } finish { specular 0.5 } }
