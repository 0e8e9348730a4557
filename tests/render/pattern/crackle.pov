// `crackle` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { crackle scale 0.4 };
#declare Q = pigment { crackle form <-0.5, 1, 0.3> metric 1.5 offset 0.1 scale 0.4 color_map { Embers } };
#declare N = normal { crackle 0.8 scale 0.35 };
Stage(P, Q, N)
