// `pavement` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { pavement number_of_sides 4 number_of_tiles 4 pattern 3 rotate x*90 scale 0.3 };
#declare Q = pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 2 interior 1 form 1 rotate x*90 scale 0.3 color_map { Embers } };
#declare N = normal { pavement 0.5 number_of_sides 3 number_of_tiles 5 pattern 2 rotate x*90 scale 0.4 };
Stage(P, Q, N)
