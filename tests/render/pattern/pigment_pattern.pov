// `pigment_pattern` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { pigment_pattern { wood turbulence 0.1 scale 0.3 } color_map { Embers } };
#declare Q = pigment { pigment_pattern { checker pigment { bozo } pigment { granite } scale 0.5 } frequency 2 color_map { Embers } };
#declare N = normal { pigment_pattern { hexagon rgb 0, rgb 0.5, rgb 1 scale 0.3 rotate x*90 } 0.5 };
Stage(P, Q, N)
