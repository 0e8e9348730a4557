// interior_texture: the inside of open, clipped and transparent things.
#version 3.7;
#include "room.inc"
cylinder { <-1.8, -0.6, 0>, <-1.8, 1.2, 0>, 0.8 open pigment { rgb <0.8, 0.3, 0.2> } interior_texture { pigment { checker rgb 1, rgb <0.2, 0.4, 0.8> scale 0.3 } } rotate x*0 }
sphere { <0, 0.4, 0>, 0.9 clipped_by { plane { <0.3, 0.5, -1>, 0.3 inverse } } texture { pigment { rgb <0.3, 0.7, 0.3> } finish { phong 0.8 } } interior_texture { pigment { granite scale 0.5 } normal { bumps 0.5 scale 0.1 } } }
box { <1.1, -0.6, -0.6>, <2.4, 1, 0.6> texture { pigment { rgbt <1, 0.8, 0.5, 0.6> } } interior_texture { gradient y texture_map { [0 pigment { rgb <0.9, 0.1, 0.1> }] [1 pigment { rgbf <0.5, 0.5, 1, 0.5> } finish { reflection 0.2 }] } } }
cone { <0.2, -0.6, -2>, 0.5, <0.2, 0.1, -2>, 0.2 open texture { pigment { rgb 0.9 } } texture { pigment { rgbt <1, 0, 0, 0.5> } } interior_texture { pigment { rgb <0.1, 0.1, 0.4> } } }
