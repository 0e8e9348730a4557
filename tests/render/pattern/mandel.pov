// `mandel` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { mandel 30 translate x*0.5 scale 1.1 };
#declare Q = pigment { mandel 25 exponent 4 exterior 2, 0.3 interior 1, 1 scale 1.3 color_map { Embers } };
#declare N = normal { mandel 12 0.4 translate x*0.5 };
Stage(P, Q, N)
