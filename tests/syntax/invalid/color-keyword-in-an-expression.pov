#version 3.7;
#declare A = 2 * rgb <1, 0, 0>;
