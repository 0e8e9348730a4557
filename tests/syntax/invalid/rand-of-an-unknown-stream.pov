#version 3.7;
#declare A = rand(0);
