// Local numbers and a choice.
#for (I, 1, Turns)
  #local A = I*2 + 1;
  #if (mod(I, 2) = 0)
    #local B = A*0.5;
  #else
    #local B = -A;
  #end
#end
