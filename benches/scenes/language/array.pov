// An array that is filled, and read.
#declare A = array[Turns];
#for (I, 0, Turns - 1)
  #declare A[I] = I*2;
#end
#for (I, 0, Turns - 1)
  #declare S = A[I] + 1;
#end
