// `cubic` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare P = pigment { cubic };
#declare Q = pigment { cubic rgb 0.1, rgb <0.9, 0.3, 0.2>, rgb 0.9 rotate <30, 40, 10> };
#declare N = normal { cubic 0.4 rotate <30, 40, 10> };
Stage(P, Q, N)
