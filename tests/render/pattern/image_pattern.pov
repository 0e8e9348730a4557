// `image_pattern` by default, with its settings, and as a normal.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { image_pattern { ppm "probe.ppm" } translate -0.5 scale 2.6 };
#declare Q = pigment { image_pattern { ppm "probe.ppm" interpolate 2 map_type 1 } turbulence 0.1 color_map { Embers } };
#declare N = normal { image_pattern { ppm "probe.ppm" interpolate 2 } 0.7 translate -0.5 scale 2.7 };
Stage(P, Q, N)
