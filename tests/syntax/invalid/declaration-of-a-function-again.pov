#version 3.7;
#declare f = function(x) { x }
#declare f = function(x) { 2*x }
