#version 3.7;
#if (1)
#declare A = 1;
