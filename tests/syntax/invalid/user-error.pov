#version 3.7;
#declare Size = -1;
#if (Size < 0)
  #error concat("Size must not be negative, it is ", str(Size, 0, 1))
#end
