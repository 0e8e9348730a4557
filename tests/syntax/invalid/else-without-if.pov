#version 3.7;
#else
