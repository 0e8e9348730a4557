#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-3, 5, -8> * 100 rgb 1 }
#include "functions.inc"
isosurface {
  function { f_sphere(x, y, z, 1.2) + 0.35*f_noise3d(x*4, y*4, z*4) + 0.1*f_noise3d(x*16, y*16, z*16) }
  contained_by { sphere { 0, 1.3 } } max_gradient 4
  pigment { rgb <0.6, 0.6, 0.65> }
}
