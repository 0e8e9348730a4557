// `function` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { function { sin(x*5)*cos(y*4) + z } color_map { Embers } };
#declare Q = pigment { function { sqrt(x*x + y*y) } frequency 3 scallop_wave color_map { Embers } };
#declare N = normal { function { sin(x*6)*sin(y*6)*sin(z*6) } 0.5 };
Stage(P, Q, N)
