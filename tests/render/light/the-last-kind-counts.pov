// `spotlight`, `cylinder` and `shadowless` are kinds of light: the last of them counts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -6> look_at <0, 0, 0> right x*image_width/image_height angle 50 }
light_source { <-2, 4, -2> rgb <0.5, 0.1, 0.1> spotlight radius 12 falloff 20 point_at <-1, 0, 0> shadowless }
light_source { <2, 4, -2> rgb <0.1, 0.5, 0.1> shadowless spotlight radius 12 falloff 20 point_at <1, 0, 0> }
light_source { <0, 4, -4> rgb <0.1, 0.1, 0.5> cylinder radius 1 falloff 2 point_at <0, 0, 1> shadowless }
plane { y, -0.6 pigment { rgb 0.9 } finish { specular 0.4 roughness 0.05 } }
sphere { <-1.2, 0.2, 0>, 0.6 pigment { rgb <0.9, 0.7, 0.5> } finish { phong 0.8 } }
sphere { <1.2, 0, -0.6>, 0.5 pigment { rgb <0.5, 0.7, 0.9> } }
