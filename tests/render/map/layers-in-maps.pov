// Layered textures, by name, as entries of texture maps, of lists and of averages.
#version 3.7;
#include "grid.inc"
#declare Lacquer =
  texture { pigment { rgb <0.9, 0.6, 0.3> } finish { reflection 0.1 } }
  texture { pigment { gradient y color_map { [0 rgbt 1] [1 rgbft <0.2, 0.5, 0.3, 0.4, 0.2>] } scale 0.3 } normal { bumps 0.5 scale 0.1 } }
  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 phong 1 } }
#declare Plain = texture { pigment { rgb 0.6 } }
Cell(texture { Lacquer })
Cell(texture { gradient x texture_map { [0.3 Lacquer] [0.7 Plain] } })
Cell(texture { bozo turbulence 0.5 texture_map { [0.4 Lacquer] [0.6 Plain] } scale 0.4 })
Cell(texture { checker texture { Lacquer } texture { Plain } scale 0.4 })
Cell(texture { average texture_map { [1 Lacquer] [2 Plain] } })
Cell(texture { hexagon texture { Lacquer } texture { Plain } texture { Lacquer } rotate x*90 scale 0.3 })
Cell(texture { gradient x texture_map { [0 Lacquer scale 0.5] [1 Lacquer rotate z*90] } })
Cell(texture { gradient x texture_map { [0 gradient y texture_map { [0 Lacquer] [1 Plain] }] [1 Lacquer] } scale <2, 1.5, 1> })
Cell(texture { tiles { texture { Lacquer } tile2 texture { Plain } } scale 0.3 })
Cell(texture { material_map { ppm "probe.ppm" texture { Lacquer } texture { Plain } } })
Cell(texture { Lacquer scale 2 rotate z*45 })
Cell(texture { Lacquer })
