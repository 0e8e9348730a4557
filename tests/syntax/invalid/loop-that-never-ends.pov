#version 3.7;
#while (1)
#end
