#version 3.7;
#macro Box(x, Height) 1 #end
