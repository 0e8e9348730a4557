// `spherical` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { spherical scale 1.5 };
#declare Q = pigment { spherical frequency 5 cubic_wave turbulence 0.2 scale 1.8 color_map { Embers } };
#declare N = normal { spherical 0.8 frequency 4 sine_wave scale 1.6 };
Stage(P, Q, N)
