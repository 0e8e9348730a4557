#version 3.7;
Tower(3, "x")
