#version 3.7;
#declare Paint = pigment { rgb 1 }
#for (I, 1, 300000)
  #declare Paint = pigment { gradient x pigment_map { [0 Paint] [1 rgb 0] } }
#end
