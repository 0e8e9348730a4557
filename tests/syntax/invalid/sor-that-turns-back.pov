#version 3.7;
global_settings { assumed_gamma 1 }
sor { 4, <0, 0>, <1, 2>, <1, 1>, <0, 3> }
