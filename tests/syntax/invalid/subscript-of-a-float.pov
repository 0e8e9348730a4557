#version 3.7;
#declare A = 3;
#declare A[0] = 1;
