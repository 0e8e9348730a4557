#version 3.7;
#if (1 + 2
#declare A = 1;
#end
