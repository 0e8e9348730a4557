// no_bump_scale: transforms change the depth of bumps, in normals, maps, textures and texture maps.
#version 3.7;
#include "grid.inc"
Bend(normal { bumps 0.3 scale 0.2 no_bump_scale })
Bend(normal { bumps 0.3 no_bump_scale scale 0.2 })
Bend(normal { bumps 0.8 scale 3 no_bump_scale })
Bend(normal { granite 0.3 scale <0.3, 1, 0.5> rotate z*30 no_bump_scale })
Bend(normal { gradient x normal_map { [0 bumps 0.4 scale 0.2 no_bump_scale] [1 dents 1 scale 0.2] } })
Bend(normal { gradient x normal_map { [0 bumps 0.4 scale 0.2] [1 dents 1 scale 0.2] } scale <2, 0.5, 1> no_bump_scale })
Bend(normal { average normal_map { [1 bumps 0.4 scale 0.2] [1 dents 1 scale 0.2] } scale <2, 0.5, 1> no_bump_scale })
Cell(texture { pigment { rgb 0.8 } normal { bumps 0.3 scale 0.2 } no_bump_scale })
Cell(texture { gradient x texture_map { [0 pigment { rgb 0.8 } normal { bumps 0.5 scale 0.2 }] [1 pigment { rgb <0.8, 0.4, 0.2> }] } scale <0.5, 2, 0.7> no_bump_scale })
Bend(normal { facets coords 0.5 size 0.2 scale 0.5 no_bump_scale })
Bend(normal { quilted 0.5 scale 0.3 no_bump_scale })
Bend(normal { gradient x 0.2 slope_map { [0 <0, 1>] [1 <1, -1>] } scale 0.3 no_bump_scale })
