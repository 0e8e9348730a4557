// Spheres, each with a place and a colour of its own.
#declare R = seed(7);
#declare I = 0;
#while (I < Turns)
  sphere {
    <rand(R)*20 - 10, sin(I)*5, I/1000>, 0.1 + 0.2*rand(R)
    pigment { rgb <rand(R), rand(R), rand(R)> }
    translate <0, 1, 0>
  }
  #declare I = I + 1;
#end
