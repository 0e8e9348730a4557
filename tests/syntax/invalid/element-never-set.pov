#version 3.7;
#declare A = array[3];
#declare B = A[0] + 1;
