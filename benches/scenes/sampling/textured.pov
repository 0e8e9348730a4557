// Marble, wood and granite.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <5, 8, -6> rgb 1 }

plane { y, 0 pigment { granite color_map { [0 rgb 0.2] [1 rgb <0.9, 0.8, 0.7>] } scale 0.5 } }
plane { z, 6 pigment { wood turbulence 0.1 color_map { [0 rgb <0.6, 0.4, 0.2>] [1 rgb <0.3, 0.15, 0.05>] } scale 0.4 } }
sphere { <-1, 0.9, 0>, 0.9 pigment { marble turbulence 0.8 color_map { [0 rgb 1] [0.6 rgb 0.7] [1 rgb <0.2, 0.25, 0.3>] } scale 0.4 } }
sphere { <1.1, 0.9, 0.3>, 0.9 pigment { rgb <0.8, 0.3, 0.2> } normal { wrinkles 0.8 scale 0.15 } finish { specular 0.6 } }
