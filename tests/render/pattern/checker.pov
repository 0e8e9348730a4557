// `checker` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { checker scale 0.37 };
#declare Q = pigment { checker rgb <0.9, 0.7, 0.2>, rgb <0.2, 0.1, 0.4> scale 0.4 rotate <30, 40, 0> turbulence 0.15 };
#declare N = normal { checker 0.5 scale 0.4 };
Stage(P, Q, N)
