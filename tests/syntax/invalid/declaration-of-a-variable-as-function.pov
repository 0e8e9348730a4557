#version 3.7;
#declare f = 1;
#declare f = function(x) { x }
