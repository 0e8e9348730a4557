// Strings put together and measured.
#for (I, 1, Turns)
  #local S = concat("n", str(I, 0, 2));
  #local L = strlen(S);
#end
