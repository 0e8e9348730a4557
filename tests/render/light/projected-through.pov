// Light that comes through a window, parallel spotlights, and coloured glass in the way.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0, 0> right x*image_width/image_height angle 50 }
light_source { <-3, 6, -3> rgb 0.9 projected_through { box { <-2.2, 2.9, -2.2>, <-1, 3, -1> } } }
light_source { <4, 6, -3> rgb <0.5, 0.4, 0.3> parallel point_at 0 spotlight radius 8 falloff 14 }
light_source { <0, 8, 2> rgb <0.3, 0.3, 0.5> }
plane { y, -0.6 pigment { rgb 0.9 } }
sphere { <-1.2, 0.2, 0>, 0.6 pigment { rgb <0.9, 0.7, 0.5> } }
box { <0.2, 1, -0.4>, <1.8, 1.1, 1.2> pigment { rgbft <1, 0.5, 0.3, 0.6, 0.2> } }
box { <0.6, 2, 0>, <2.2, 2.05, 1.6> pigment { rgbft <0.3, 0.8, 1, 0.7, 0.1> } }
