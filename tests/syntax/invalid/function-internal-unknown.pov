#version 3.7;
#declare f = function { internal(79) }
