// Turns by many angles: the last digits are those of one formula and no other.
#declare R = seed(11);
#for (I, 1, 40)
  #declare A = <rand(R) * 10 - 5, rand(R) * 10 - 5, rand(R) * 10 - 5>;
  #declare B = <rand(R) * 600 - 300, rand(R) * 600 - 300, rand(R) * 600 - 300>;
  V(vrotate(A, B) * 1e9)
  V(vaxis_rotate(A, B, rand(R) * 600 - 300) * 1e9)
#end
