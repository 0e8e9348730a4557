// `cells` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { cells scale 0.31 };
#declare Q = pigment { cells frequency 3 phase 0.4 scale <0.7, 0.2, 0.3> color_map { Embers } };
#declare N = normal { cells 0.5 scale 0.4 };
Stage(P, Q, N)
