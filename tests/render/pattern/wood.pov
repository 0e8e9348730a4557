// `wood` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { wood scale 0.4 };
#declare Q = pigment { wood turbulence 0.15 rotate 30 frequency 2 scale 0.6 color_map { Embers } };
#declare N = normal { wood 0.5 turbulence 0.1 scale 0.4 };
Stage(P, Q, N)
