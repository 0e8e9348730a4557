#version 3.7;
#declare Name = "Tower;
#declare A = 1;
