#version 3.7;
#declare Sphare = 1;
#declare A = Sphere;
