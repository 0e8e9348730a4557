#version 3.7;
#declare sphere = 3;
