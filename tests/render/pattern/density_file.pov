// `block.df3` holds 4 by 3 by 5 voxels of 8 bits.
#version 3.7;
#include "stage.inc"
#declare Embers = color_map { [0 rgb <0.1, 0.05, 0.2>] [0.5 rgb <0.9, 0.4, 0.2>] [1 rgb <1, 0.95, 0.7>] };
#declare P = pigment { density_file df3 "block.df3" interpolate 1 translate -0.5 scale 2.6 };
#declare Q = pigment { density_file df3 "block.df3" interpolate 2 translate -0.5 scale 2.6 rotate 20 color_map { Embers } };
#declare N = normal { density_file df3 "block.df3" 0.6 interpolate 1 translate -0.5 scale 2.7 };
Stage(P, Q, N)
