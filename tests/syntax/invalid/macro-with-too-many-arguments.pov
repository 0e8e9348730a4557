#version 3.7;
#macro Box(Width, Height)
  Width * Height
#end
#declare A = Box(2, 3, 4);
