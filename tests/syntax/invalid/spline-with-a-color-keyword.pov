#version 3.7;
#declare S = spline { 0, rgb 1 1, rgb 0 }
