// `aoi` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { aoi };
#declare Q = pigment { aoi frequency 6 triangle_wave };
#declare N = normal { aoi 0.4 };
Stage(P, Q, N)
