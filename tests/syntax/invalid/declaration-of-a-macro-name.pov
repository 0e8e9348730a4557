#version 3.7;
#macro Tower() 1 #end
#declare Tower = 3;
