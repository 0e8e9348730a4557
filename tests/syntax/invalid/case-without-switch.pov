#version 3.7;
#case (1)
