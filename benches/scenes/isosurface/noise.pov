#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-3, 5, -8> * 100 rgb 1 }
#include "functions.inc"
isosurface {
  function { y + 0.6*f_noise3d(x*2.5, y*2.5, z*2.5) }
  contained_by { box { <-3, -1, -3>, <3, 0.5, 3> } } max_gradient 2.2
  pigment { rgb <0.6, 0.55, 0.5> }
}
