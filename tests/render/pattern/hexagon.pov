// `hexagon` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { hexagon scale 0.3 rotate x*90 };
#declare Q = pigment { hexagon rgb 0.9, rgb <0.2, 0.5, 0.3>, rgb <0.5, 0.2, 0.1> rotate x*60 scale 0.4 };
#declare N = normal { hexagon 0.5 scale 0.3 rotate x*90 };
Stage(P, Q, N)
