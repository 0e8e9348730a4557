// Two rainbows, one an arc with ends that fade.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -8> look_at <0, 3, 0> right x*image_width/image_height angle 90 }
light_source { <-8, 12, -20> rgb 1 }
background { rgb <0.45, 0.55, 0.7> }
plane { y, -1 pigment { rgb <0.4, 0.6, 0.3> } }
box { <-3, -1, 3>, <-1, 5, 5> pigment { rgb 0.8 } }
#declare Colors = color_map { [0 rgbt <0.6, 0, 1, 0.9>] [0.3 rgbt <0, 0.3, 1, 0.8>] [0.6 rgbt <0.3, 1, 0.2, 0.8>] [1 rgbt <1, 0.1, 0, 0.9>] }
rainbow { direction <0.1, -0.2, 1> angle 38 width 6 distance 1000 color_map { Colors } }
rainbow { direction <0.1, -0.2, 1> angle 50 width 8 distance 50 arc_angle 150 falloff_angle 60 up <0.1, 1, 0> color_map { [0 rgb <1, 0.3, 0>] [1 rgbf <0.2, 0.3, 1, 0.5>] } }
