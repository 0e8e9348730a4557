#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-3, 5, -8> * 100 rgb 1 }
#include "functions.inc"
isosurface {
  function { min(f_rounded_box(x, y, z, 0.1, 0.9, 0.3, 0.9), f_torus(x, y - 0.4, z, 0.7, 0.25)) }
  contained_by { box { -1.5, 1.5 } } max_gradient 1.6
  pigment { rgb <0.5, 0.5, 0.8> }
}
