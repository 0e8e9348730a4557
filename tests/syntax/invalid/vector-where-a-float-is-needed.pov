#version 3.7;
#declare A = sin(<1, 2, 3>);
