// `bozo` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { bozo scale 0.4 };
#declare Q = pigment { bozo turbulence 0.8 omega 0.7 noise_generator 1 scale 0.5 color_map { Embers } };
#declare N = normal { bozo 0.9 scale 0.2 };
Stage(P, Q, N)
