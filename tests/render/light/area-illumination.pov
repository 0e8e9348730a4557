// Every lamp of a grid lights by itself; a spotlight with a grid; a fading one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0, 0> right x*image_width/image_height angle 50 }
light_source { <0, 2, 0> rgb 0.8 area_light 4*x, 3*z, 5, 4 area_illumination on fade_distance 2 fade_power 2 }
light_source { <-4, 4, -4> rgb <0.6, 0.3, 0.2> spotlight radius 12 falloff 20 point_at 0 area_light x, y, 4, 4 adaptive 0 }
plane { y, -0.6 pigment { rgb 0.9 } finish { specular 0.4 roughness 0.05 } }
sphere { <-1.2, 0.2, 0>, 0.6 pigment { rgb <0.9, 0.7, 0.5> } finish { phong 0.8 } }
sphere { <1.2, 0, -0.6>, 0.5 pigment { rgb <0.5, 0.7, 0.9> } }
