// #default: what new textures, entries of maps and missing entries of lists start from.
#version 3.7;
#include "grid.inc"
#default { texture { pigment { bozo scale 0.2 color_map { [0 rgb <0.2, 0.1, 0.4>] [1 rgb <1, 0.9, 0.5>] } } finish { ambient 0.3 phong 0.6 } } }
Cell(texture { })
Cell(texture { pigment { gradient x } })
Cell(texture { pigment { rgb <0.8, 0.3, 0.2> } })
Cell(texture { pigment { gradient x pigment_map { [0 granite] [1 scale 0.3] } } })
Cell(texture { pigment { checker pigment { rgb 1 } scale 0.4 } })
#default { normal { bumps 0.8 scale 0.1 } }
Cell(texture { pigment { rgb 0.8 } })
Cell(texture { normal { gradient x normal_map { [0 dents 2 scale 0.2] [1 scale 3] } } })
#default { finish { diffuse 0.4 ambient 0.5 } }
Cell(texture { pigment { rgb <0.2, 0.6, 0.9> } finish { phong 0 } })
#default { pigment { rgb <0.3, 0.7, 0.3> } }
Cell(texture { })
Cell(texture { checker texture { pigment { rgb 1 } } scale 0.4 })
Cell(texture { normal { checker normal { wood 1 scale 0.1 } scale 0.4 } })
Cell(texture { gradient x texture_map { [0 ] [1 pigment { rgb <0.8, 0.6, 0.3> }] } })
