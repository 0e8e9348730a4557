#version 3.7;
#declare A = concat("A = ", 3);
