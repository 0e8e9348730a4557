#version 3.7;
#for (I, 1, 3)
  #undef I
#end
