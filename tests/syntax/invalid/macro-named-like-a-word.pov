#version 3.7;
#macro box() 1 #end
