// average of pigments, normals and textures, with weights, without, negative, and one alone.
#version 3.7;
#include "grid.inc"
#declare Stripes = pigment { gradient y color_map { [0.5 rgb 0.2] [0.5 rgb 0.9] } scale 0.2 }
#declare Red = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 1 phong_size 10 } }
#declare Mirror = texture { pigment { rgb 0.3 } finish { reflection 0.5 } }
Paint(pigment { average pigment_map { [1 Stripes] [1 granite scale 0.3] } })
Paint(pigment { average pigment_map { [Stripes] [3 bozo scale 0.2] [0.5 rgb <1, 0.4, 0>] } })
Paint(pigment { average turbulence 0.3 pigment_map { [1 Stripes] [1 gradient x scale 0.2] } })
Paint(pigment { average pigment_map { [-1 rgb 0.2] [3 Stripes] } })
Paint(pigment { average pigment_map { [0.3 rgbt <1, 0.6, 0.2, 0.8>] [0.7 rgbf <0.4, 0.7, 1, 0.9>] } })
Bend(normal { average normal_map { [1 bumps 1 scale 0.1] [2 gradient x 1 triangle_wave scale 0.2] } })
Bend(normal { average normal_map { [ripples 1 frequency 3 scale 0.3] [dents 2 scale 0.2] } scale <1, 2, 1> })
Bend(normal { average normal_map { [0.5 facets coords 1 size 0.2] } })
Cell(texture { average texture_map { [1 Red] [3 Mirror] } })
Cell(texture { average texture_map { [1 Red] [1 gradient x texture_map { [0 Mirror] [1 Red] }] } })
Cell(texture { average texture_map { [2 pigment { Stripes } normal { bumps 1 scale 0.1 }] [1 pigment { rgbt 1 }] } })
Cell(texture { checker texture { Red } texture { average texture_map { [1 Red] [1 pigment { Stripes }] } } scale 0.4 })
