// Nothing but turns.
#declare I = 0;
#while (I < Turns)
  #declare I = I + 1;
#end
