#version 3.7;
#declare Height = 1;
#declare f = function(Height) { Height }
