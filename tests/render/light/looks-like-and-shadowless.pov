// A visible light, a light without shadows, a light through a hole.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }

light_source { <-1.2, 1, -0.5> rgb 0.7 looks_like { sphere { 0, 0.2 pigment { rgb <1, 0.9, 0.5> } finish { emission 1 } } } }
light_source { <4, 3, -4> rgb <0.1, 0.2, 0.3> shadowless }
light_source { <3, 4, 0> rgb <0.8, 0.3, 0.3> projected_through { disc { <1.5, 2, 0>, <1, 1, 0>, 0.4 } } }
plane { y, -0.6 pigment { rgb 0.9 } }
sphere { <0, 0.1, 0>, 0.5 pigment { rgb <0.9, 0.7, 0.5> } }
