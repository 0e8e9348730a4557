#version 3.7;
#macro Box(Width) Width #end
#declare A = Box(Sise);
