// `spiral2` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { spiral2 3 scale 0.6 };
#declare Q = pigment { spiral2 5 turbulence 0.2 frequency 2 color_map { Embers } };
#declare N = normal { spiral2 4 0.5 scale 0.5 };
Stage(P, Q, N)
