#version 3.7;
#declare Pair = sphere { 0, 1 };
#for (I, 1, 40)
  #declare Pair = union { object { Pair } object { Pair translate I } };
#end
