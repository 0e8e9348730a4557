#version 3.7;
#if (0)
#else
#else
#end
