#version 3.7;
#declare A = 1 + #if (0) 2 #else 3 #end * 2;
