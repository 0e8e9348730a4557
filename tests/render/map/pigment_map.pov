// pigment_map: children see the parent's warped point, except below marble and wood; nested, unsorted and uncoloured ones.
#version 3.7;
#include "grid.inc"
#declare Stripes = pigment { gradient y color_map { [0.5 rgb 0.2] [0.5 rgb 0.9] } scale 0.2 }
Paint(pigment { gradient x pigment_map { [0.2 Stripes] [0.8 rgb <1, 0.4, 0.2>] } })
Paint(pigment { bozo turbulence 0.5 pigment_map { [0.4 Stripes] [0.6 rgb <0.2, 0.4, 0.9>] } scale 0.4 })
Paint(pigment { marble turbulence 0.5 pigment_map { [0.2 Stripes] [0.8 rgb <0.2, 0.4, 0.9>] } scale 0.7 })
Paint(pigment { wood turbulence 0.2 pigment_map { [0.2 Stripes] [0.8 rgb <0.2, 0.4, 0.9>] } scale 0.7 })
Paint(pigment { agate turbulence 0.3 pigment_map { [0.2 Stripes rotate z*45] [0.8 granite] } scale 0.7 })
Paint(pigment { gradient y pigment_map { [0 gradient x pigment_map { [0 rgb <1, 0, 0>] [1 Stripes] }] [1 checker rgb 0, rgb 1 scale 0.2] } scale 2 translate y })
Paint(pigment { gradient x pigment_map { [0.7 rgb <1, 0.2, 0.2>] [0.3 Stripes] [0.5 rgb <0.2, 0.2, 1>] } })
Paint(pigment { radial rotate x*90 frequency 3 pigment_map { [0 rgbt <1, 0.5, 0.2, 0.9>] [1 rgbf <0.5, 0.9, 1, 0.9>] } })
Paint(pigment { hexagon pigment { Stripes } pigment { rgb <1, 0.8, 0.3> } pigment { granite scale 0.3 } rotate x*90 scale 0.4 })
Paint(pigment { checker pigment { Stripes } pigment { wood scale 0.1 } scale 0.5 })
Paint(pigment { crackle solid pigment_map { [0.5 Stripes] [0.5 rgb <0.7, 0.2, 0.2>] } scale 0.3 })
Paint(pigment { gradient x pigment_map { [0 scale 3] [0.5 bozo] [1 gradient y color_map { [0 rgb 1] [1 rgb 0] } scale 0.3] } })
