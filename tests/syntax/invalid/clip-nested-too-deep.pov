#version 3.7;
#declare Ball = sphere { 0, 1 }
#for (I, 1, 300000)
  #declare Ball = sphere { 0, 1 clipped_by { Ball } }
#end
