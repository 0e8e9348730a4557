#version 3.7;
#macro Box()
  #if (1)
#end
