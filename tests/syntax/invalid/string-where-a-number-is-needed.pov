#version 3.7;
#declare Name = "x";
#declare A = 1 + Name;
