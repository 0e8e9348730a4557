// `julia` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { julia <0.353, 0.288>, 30 scale 0.9 color_map { Embers } };
#declare Q = pigment { julia <-0.7, 0.2>, 40 exponent 3 exterior 6, 0.1 interior 1, 1 color_map { Embers } };
#declare N = normal { julia <0.353, 0.288>, 8 0.4 exterior 4, 0.05 };
Stage(P, Q, N)
