#version 3.7;
#macro One 1 #end
