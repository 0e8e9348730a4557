// `boxed` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { boxed scale 1.4 };
#declare Q = pigment { boxed frequency 4 triangle_wave scale 1.8 };
#declare N = normal { boxed 0.7 frequency 3 sine_wave scale 1.5 };
Stage(P, Q, N)
