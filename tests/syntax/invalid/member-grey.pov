#version 3.7;
#declare A = rgb 1;
#declare B = A.grey;
