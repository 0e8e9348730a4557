#version 3.7;
#macro One() 1 #end
#declare A = One + 1;
