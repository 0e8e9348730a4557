#version 3.7;
#declare f = function(x) { (x > 0 ? 1 : 2) }
