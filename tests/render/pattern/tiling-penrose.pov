// The tilings without a period.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { tiling 25 rotate x*90 scale 0.3 };
#declare Q = pigment { tiling 26 rotate x*90 scale 0.4 translate 0.3 color_map { Embers } };
#declare N = normal { tiling 27 0.5 rotate x*90 scale 0.4 };
Stage(P, Q, N)
