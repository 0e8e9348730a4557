// `planar` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { planar scale 1.3 rotate z*20 };
#declare Q = pigment { planar frequency 4 triangle_wave turbulence 0.2 color_map { Embers } };
#declare N = normal { planar 0.8 frequency 3 sine_wave };
Stage(P, Q, N)
