#version 3.7;
#if (1)
  #break
#end
