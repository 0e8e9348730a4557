// texture_map and lists of textures: blended finishes, nested patterns, transforms, bumps, filter and transmit.
#version 3.7;
#include "grid.inc"
#declare Red = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 1 phong_size 10 } }
#declare Mirror = texture { pigment { rgb 0.3 } finish { reflection 0.5 } }
#declare Rough = texture { pigment { gradient y color_map { [0.5 rgb 0.2] [0.5 rgb 0.9] } scale 0.2 } normal { bumps 1 scale 0.1 } }
#declare Glass = texture { pigment { rgbft <0.5, 0.8, 1, 0.5, 0.4> } finish { specular 0.8 } }
Cell(texture { gradient x texture_map { [0.3 Red] [0.7 Mirror] } })
Cell(texture { bozo turbulence 0.5 texture_map { [0.4 Red] [0.6 Rough] } scale 0.4 })
Cell(texture { gradient x texture_map { [0.2 Glass] [0.8 Rough] } })
Cell(texture { gradient x texture_map { [0 gradient y texture_map { [0 Red] [1 Mirror] }] [1 Rough] } scale 1.5 })
Cell(texture { checker texture { Red } texture { Rough } scale 0.4 })
Cell(texture { brick texture { Rough } texture { Mirror } scale 0.1 rotate z*20 })
Cell(texture { hexagon texture { Red } texture { Rough } texture { Glass } rotate x*90 scale 0.4 })
Cell(texture { square texture { Red } texture { Mirror } rotate x*90 scale 0.4 })
Cell(texture { object { sphere { 0, 0.6 } texture { Red } texture { Rough } } })
Cell(texture { gradient x texture_map { [0 Rough] [1 Rough rotate z*90] } scale <1, 0.5, 2> rotate z*20 })
Cell(texture { gradient x texture_map { [0 Rough] [1 Red] } scale <0.5, 2, 0.7> no_bump_scale })
Cell(texture { tiles { texture { Red } tile2 texture { Rough } } scale 0.4 })
