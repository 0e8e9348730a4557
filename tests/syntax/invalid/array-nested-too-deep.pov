#version 3.7;
#declare List = array[1] { 0 }
#for (I, 1, 300000)
  #declare Outer = array[1] { List }
  #declare List = Outer;
#end
