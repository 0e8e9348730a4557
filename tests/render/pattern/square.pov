// `square` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { square scale 0.3 rotate x*90 };
#declare Q = pigment { square rgb 0.1, rgb 0.9, rgb <0.8, 0.3, 0.1>, rgb <0.2, 0.5, 0.7> rotate <70, 0, 30> scale 0.4 };
#declare N = normal { square 0.5 scale 0.35 rotate x*90 };
Stage(P, Q, N)
