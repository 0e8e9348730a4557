// Hills and a boulder made of noise: nothing of them is flat, and max_gradient is right.
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-3, 5, -8> * 100 rgb 1 }
isosurface {
  function { y + 0.6*f_noise3d(x*2.5, y*2.5, z*2.5) }
  contained_by { box { <-3, -1, -3>, <3, 0.5, 3> } }
  max_gradient 2.2
  pigment { rgb <0.6, 0.55, 0.5> }
}
isosurface {
  function { f_sphere(x, y, z, 0.7) + 0.2*f_noise3d(x*4, y*4, z*4) + 0.05*f_noise3d(x*16, y*16, z*16) }
  contained_by { sphere { 0, 0.75 } }
  max_gradient 3
  pigment { rgb <0.6, 0.6, 0.65> }
  translate <0.3, 0.6, 0>
}
