// `magnet` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { magnet 1 mandel 25 exterior 1, 1 translate -x*1.2 scale 0.6 color_map { Embers } };
#declare Q = pigment { magnet 2 julia <1.7, -1.3>, 20 exterior 6, 0.002 interior 1, 0.5 scale 0.7 color_map { Embers } };
#declare N = normal { magnet 1 mandel 12 0.4 scale 0.7 };
Stage(P, Q, N)
