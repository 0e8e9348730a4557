// `crackle` with `solid`, and with other metrics.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { crackle solid scale 0.4 color_map { Embers } };
#declare Q = pigment { crackle form <1, 0, 0> metric 1 scale 0.5 turbulence 0.2 color_map { Embers } };
#declare N = normal { crackle 0.8 form <1, 0, 0> scale 0.35 };
Stage(P, Q, N)
