#version 3.7;
#declare Big = 1 > 0 ? 10 : 1;
