#version 3.7;
#declare f = function(x) { sin(x, 1) }
