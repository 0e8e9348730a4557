#version 3.7;
#declare Red = rgb <1, 0, 0>;
#declare A = vlength(Red);
