#version 3.7;
#declare Up = <0, 1, 0>;
#declare f = function(x) { Up.y * x }
