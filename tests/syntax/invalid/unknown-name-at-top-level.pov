#version 3.7;
Sphere { 0, 1 }
#declare A = 1;
