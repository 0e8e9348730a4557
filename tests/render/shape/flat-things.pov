// Discs, triangles, polygons and meshes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

disc { <-1.7, 0.3, 0>, <0.4, 0.5, -1>, 0.6, 0.25 pigment { rgb <0.9, 0.4, 0.3> } }
triangle { <-0.9, -0.5, 0>, <0, -0.5, -0.3>, <-0.4, 0.9, 0.2> pigment { rgb <0.9, 0.8, 0.3> } }
smooth_triangle { <0.1, -0.5, 0>, <-1, 0.3, -1>, <1, -0.5, -0.3>, <1, 0.3, -1>, <0.5, 0.9, 0.2>, <0, 1, -1> pigment { rgb <0.3, 0.8, 0.4> } finish { phong 0.8 } }
polygon { 10, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>, <0.3, 0.3>, <0.7, 0.3>, <0.7, 0.7>, <0.3, 0.7>, <0.3, 0.3> rotate <10, 20, 5> translate <1.1, -0.4, 0> pigment { rgb <0.3, 0.5, 0.9> } }
