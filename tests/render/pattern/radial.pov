// `radial` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { radial rotate x*90 };
#declare Q = pigment { radial frequency 8 sine_wave turbulence 0.1 rotate x*70 color_map { Embers } };
#declare N = normal { radial 0.6 frequency 12 sine_wave rotate x*90 };
Stage(P, Q, N)
