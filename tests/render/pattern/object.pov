// `object` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { object { torus { 0.8, 0.3 rotate x*90 } } };
#declare Q = pigment { object { union { box { -0.6, 0.6 rotate 30 } sphere { x, 0.6 } } rgb <0.9, 0.8, 0.3>, rgb <0.2, 0.3, 0.6> } turbulence 0.1 };
#declare N = normal { object { torus { 0.8, 0.3 rotate x*90 translate -z*1.1 } } 0.5 };
Stage(P, Q, N)
