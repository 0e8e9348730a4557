#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 matrix <0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0> }
