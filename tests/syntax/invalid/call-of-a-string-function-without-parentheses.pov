#version 3.7;
#declare A = strlen "abc";
