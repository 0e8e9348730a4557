// A macro that is a number.
#macro M(A, B) A*B + I #end
#for (I, 1, Turns)
  #local S = M(I, 2);
#end
