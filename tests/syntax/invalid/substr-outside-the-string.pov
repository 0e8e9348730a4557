#version 3.7;
#declare A = substr("abc", 2, 5);
