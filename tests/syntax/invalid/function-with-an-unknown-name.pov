#version 3.7;
#declare f = function(x) { x + Heihgt }
