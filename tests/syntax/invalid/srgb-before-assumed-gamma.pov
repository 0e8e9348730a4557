#version 3.7;
#declare A = srgb <1, 0.5, 0>;
