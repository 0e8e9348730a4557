// `agate` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { agate scale 0.8 };
#declare Q = pigment { agate agate_turb 0.4 turbulence 0.3 octaves 4 frequency 2 sine_wave };
#declare N = normal { agate 0.6 scale 0.4 };
Stage(P, Q, N)
