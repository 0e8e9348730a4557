// `wrinkles` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { wrinkles scale 0.3 };
#declare Q = pigment { wrinkles noise_generator 1 turbulence 0.3 color_map { Embers } };
#declare N = normal { wrinkles 0.6 scale 0.3 };
Stage(P, Q, N)
