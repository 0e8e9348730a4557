// `brick` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { brick scale 0.15 };
#declare Q = pigment { brick rgb 0.9, rgb <0.1, 0.5, 0.4> brick_size <1, 0.5, 0.5> mortar 0.06 turbulence 0.05 };
#declare N = normal { brick 0.6 scale 0.15 };
Stage(P, Q, N)
