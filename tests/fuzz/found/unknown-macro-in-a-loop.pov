// Ten thousand times the same mistake, with a name to look for each time.
#declare I = 0;
#while (I < 20000)
  Zork(I)
  #declare I = I + 1;
#end
