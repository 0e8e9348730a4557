// A macro that makes an object.
#macro Ball(Place, Radius, Color)
  #local Center = Place + <0, Radius, 0>;
  sphere { Center, Radius pigment { color rgb Color } }
#end
#for (I, 1, Turns)
  Ball(<I, 0, 0>, 0.5, <1, mod(I, 2), 0>)
#end
