// cutaway_textures: cut faces take the texture of what was cut, not of what cut it.
#version 3.7;
#include "room.inc"
difference {
  sphere { <-1.7, 0.4, 0>, 0.9 }
  box { <-1.9, 0.5, -2>, <0, 2, 2> }
  pigment { wood scale 0.2 rotate x*90 } cutaway_textures
}
difference {
  union { sphere { <0.2, 0.3, 0>, 0.8 pigment { rgb <0.8, 0.3, 0.2> } } cylinder { <0.2, -0.6, 0>, <0.2, 1.4, 0>, 0.3 pigment { rgb <0.2, 0.5, 0.8> } } }
  box { <0, -1, -2>, <0.6, 2, 0> }
  cutaway_textures
}
intersection {
  box { <1.3, -0.6, -0.7>, <2.7, 0.9, 0.7> pigment { rgb <0.9, 0.8, 0.3> } }
  sphere { <2, 0.2, -0.2>, 0.9 pigment { checker rgb 0.1, rgb 0.9 scale 0.2 } }
  plane { <1, 1, 0>, 2.1 }
  pigment { rgb <0.5, 0.9, 0.5> } cutaway_textures
}
