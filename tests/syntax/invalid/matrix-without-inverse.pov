#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 matrix <1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 0> }
