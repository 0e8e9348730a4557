#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 pigment { gradient x warp { repeat <1, 1, 0> } } }
