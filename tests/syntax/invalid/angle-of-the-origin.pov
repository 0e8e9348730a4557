#version 3.7;
#declare A = atan2(0, 0);
