#version 3.7;
global_settings { assumed_gamma 1 }
#undef Radius
sphere { 0, 1 }
