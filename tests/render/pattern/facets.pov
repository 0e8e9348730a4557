// `facets` bends normals only; the two panels are company for it.
#version 3.7;
#include "stage.inc"
#declare P = pigment { bozo scale 0.3 };
#declare Q = pigment { rgb <0.6, 0.7, 0.8> };
#declare N = normal { facets coords 0.5 size 0.25 };
Stage(P, Q, N)
