#version 3.7;
#declare A = ;
#declare B = 1;
