#version 3.7;
global_settings { assumed_gamma 1 }
prism { linear_spline 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
