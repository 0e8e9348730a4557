#version 3.7;
#declare f = function { spline { 0, x 1, y } }
#declare g = function(x) { f(x) }
