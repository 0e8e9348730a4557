// `slope` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { slope y };
#declare Q = pigment { slope { <1, 1, -1>, 0.3, 0.9 altitude y, -1.5, 1.5 } color_map { Embers } };
#declare N = normal { slope { point_at <1, 5, -7>, 0.2, 0.9 } 0.5 frequency 5 };
Stage(P, Q, N)
