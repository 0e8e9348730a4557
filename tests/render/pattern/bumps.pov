// `bumps` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { bumps scale 0.3 };
#declare Q = pigment { bumps noise_generator 3 frequency 4 scallop_wave scale 0.6 color_map { Embers } };
#declare N = normal { bumps 0.7 scale 0.15 };
Stage(P, Q, N)
