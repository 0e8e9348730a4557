#version 3.7;
#declare F = function(x) { x }
#for (I, 1, 300000)
  #declare G = function(x) { F(x) + 1 }
  #undef F
  #declare F = function(x) { G(x) }
  #undef G
#end
