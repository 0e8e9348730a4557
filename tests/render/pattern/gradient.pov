// `gradient` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { gradient x scale 0.7 };
#declare Q = pigment { gradient <1, 2, -1> triangle_wave frequency 3 phase 0.2 turbulence 0.2 color_map { Embers } };
#declare N = normal { gradient y 0.5 triangle_wave scale 0.4 };
Stage(P, Q, N)
