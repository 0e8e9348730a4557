#version 3.7;
#declare Radius = 2;
#declare Area = pi * pow(Raduis, 2);
