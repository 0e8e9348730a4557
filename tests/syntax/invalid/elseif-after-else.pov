#version 3.7;
#if (0)
#else
#elseif (1)
#end
