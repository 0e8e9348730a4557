// color_map: gaps at both ends, equal positions, unsorted positions, one entry, the old form, filter and transmit.
#version 3.7;
#include "grid.inc"
Paint(pigment { gradient x color_map { [0.2 rgb <1, 0.3, 0.1>] [0.7 rgb <0.1, 0.4, 0.9>] } })
Paint(pigment { gradient x color_map { [0 rgb 0] [0.3 rgb 1] [0.3 rgb <1, 0, 0>] [0.3 rgb <0, 1, 0>] [0.7 rgb <0, 0, 1>] [0.7 rgb 0.8] } })
Paint(pigment { gradient x color_map { [0.8 rgb <1, 0.2, 0.2>] [0.3 rgb <0.2, 1, 0.2>] [0.6 rgb <0.2, 0.2, 1>] } })
Paint(pigment { gradient x color_map { [0.5 rgb <0.3, 0.7, 0.9>] } })
Paint(pigment { gradient x color_map { [-1 rgb <1, 0, 0>] [2 rgb <0, 0, 1>] } })
Paint(pigment { gradient x color_map { [0, 0.4 color rgb <1, 0.5, 0> color rgb <1, 1, 0.5>] [0.4, 1 color rgb <0, 0.4, 0.2> color rgb <0.6, 1, 0.7>] } })
Paint(pigment { gradient x color_map { [0 rgbt <1, 0.5, 0, 0.9>] [1 rgbf <0.3, 0.6, 1, 0.8>] } })
Paint(pigment { gradient x color_map { [0.1 rgb 2] [0.5 rgb <-0.5, 0.5, 3>] [0.9 rgb <0.2, 0, 0>] } })
Paint(pigment { gradient x sine_wave frequency 2 color_map { [0 srgb <0.2, 0.1, 0.4>] [1 srgb <1, 0.9, 0.6>] } })
#declare Named = color_map { [0 rgb <0.1, 0.3, 0.1>] [1 rgb <0.9, 1, 0.6>] }
Paint(pigment { bozo scale 0.2 color_map { Named } })
Paint(pigment { wood scale 0.3 })
Paint(pigment { marble turbulence 0.5 scale 0.5 color_map { [0 color red 0.5] [0.5 color green 0.8 blue 0.2] [1 color rgb 1] } })
