// `quilted` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { quilted scale 0.5 };
#declare Q = pigment { quilted control0 0.3 control1 0.1 scale 0.5 color_map { Embers } };
#declare N = normal { quilted 1.2 control0 0.2 control1 1 scale 0.4 };
Stage(P, Q, N)
