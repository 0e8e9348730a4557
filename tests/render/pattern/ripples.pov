// `ripples` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { ripples scale 0.2 };
#declare Q = pigment { ripples frequency 3 phase 0.2 turbulence 0.2 scale 0.4 color_map { Embers } };
#declare N = normal { ripples 0.6 frequency 5 scale 0.4 };
Stage(P, Q, N)
