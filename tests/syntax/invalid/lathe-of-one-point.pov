#version 3.7;
lathe { linear_spline 1, <1, 0> }
