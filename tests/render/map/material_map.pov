// material_map: by red bytes, wrapped around the number of textures, on a ball, once, and transformed.
#version 3.7;
#include "grid.inc"
#declare Red = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 1 phong_size 10 } }
#declare Rough = texture { pigment { gradient y color_map { [0.5 rgb 0.2] [0.5 rgb 0.9] } scale 0.2 } normal { bumps 1 scale 0.1 } }
#declare Blue = texture { pigment { rgb <0.2, 0.4, 0.9> } }
#declare Gold = texture { pigment { rgb <0.9, 0.7, 0.2> } finish { metallic specular 0.8 } }
Cell(texture { material_map { ppm "probe.ppm" texture { Red } texture { Rough } texture { Blue } } })
Cell(texture { material_map { ppm "probe.ppm" texture { Red } texture { Rough } texture { Blue } texture { Gold } } })
Cell(texture { material_map { ppm "probe.ppm" texture { Red } } })
Cell(texture { material_map { ppm "probe.ppm" texture { Red } texture { Rough } } scale 0.5 rotate z*30 })
Cell(texture { material_map { ppm "probe.ppm" map_type 1 texture { Red } texture { Rough } texture { Blue } } })
Cell(texture { material_map { ppm "probe.ppm" once texture { Red } texture { Rough } texture { Blue } } scale 1.2 translate -0.5 })
Cell(texture { material_map { ppm "probe.ppm" interpolate 2 texture { Red } texture { Rough } texture { Blue } texture { Gold } } })
Cell(texture { material_map { ppm "probe.ppm" map_type 2 texture { Gold } texture { Rough } texture { Blue } } rotate x*20 })
Cell(texture { gradient x texture_map { [0 material_map { ppm "probe.ppm" texture { Red } texture { Rough } }] [1 Blue] } })
Cell(texture { material_map { ppm "probe.ppm" texture { gradient x texture_map { [0 Red] [1 Blue] } scale 0.2 } texture { Gold } } })
Cell(texture { checker texture { material_map { ppm "probe.ppm" texture { Red } texture { Rough } } scale 0.3 } texture { Blue } scale 0.5 })
Cell(texture { material_map { ppm "probe.ppm" gamma 2.2 texture { Red } texture { Rough } texture { Blue } } })
