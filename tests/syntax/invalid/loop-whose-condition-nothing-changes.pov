#version 3.7;
#declare I = 0;
#declare Last = 10;
#while (I < Last)
  sphere { x*I, 0.5 }
#end
