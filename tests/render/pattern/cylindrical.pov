// `cylindrical` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { cylindrical scale 1.5 rotate x*90 };
#declare Q = pigment { cylindrical frequency 5 sine_wave scale 1.8 rotate <60, 20, 0> color_map { Embers } };
#declare N = normal { cylindrical 0.8 frequency 4 sine_wave scale 1.5 rotate x*90 };
Stage(P, Q, N)
