// povista-compat: +Q5
// quick_color replaces pigments at quality 5 and lower, unless a component is -1.
#version 3.7;
#include "grid.inc"
Paint(pigment { bozo scale 0.2 quick_color rgb <0.9, 0.3, 0.1> })
Paint(pigment { bozo scale 0.2 })
Paint(pigment { rgb <0.2, 0.4, 0.9> quick_color rgb <0.1, 0.8, 0.3> })
Paint(pigment { bozo quick_color rgb <1, 1, 0> scale 0.2 quick_color rgb <0, 1, 1> })
Paint(pigment { granite quick_color rgb <-1, 0.5, 0.5> })
Paint(pigment { gradient x pigment_map { [0 bozo quick_color rgb <1, 0, 1>] [1 rgb 0.3] } })
Paint(pigment { gradient x pigment_map { [0 bozo] [1 rgb 0.3] } quick_color rgb <0, 0.7, 0.7> })
Cell(texture { pigment { rgb 1 } } )
Cell(texture { gradient x texture_map { [0 pigment { bozo quick_color rgb <1, 0.5, 0.5> }] [1 pigment { rgb 0.2 }] } })
Paint(pigment { checker rgb 0, rgb 1 quick_color rgb 0.5 scale 0.3 })
Paint(pigment { crackle scale 0.2 quick_color rgb <0.4, 0.2, 0.1> })
Paint(pigment { rgb <0.9, 0.8, 0.7> })
