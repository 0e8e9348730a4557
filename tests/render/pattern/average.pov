// `average` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { average pigment_map { [2 bozo scale 0.3] [1 gradient x triangle_wave] [1 rgb <0.2, 0.4, 0.9>] } };
#declare Q = pigment { average pigment_map { [1 granite] [1 hexagon scale 0.3 rotate x*90] } scale 0.7 };
#declare N = normal { average normal_map { [1 bumps 1 scale 0.2] [2 dents 2 scale 0.3] } };
Stage(P, Q, N)
