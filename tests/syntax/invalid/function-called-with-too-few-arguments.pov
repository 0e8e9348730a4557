#version 3.7;
#declare f = function(a, b) { a * b }
#declare g = function(x) { f(x) }
