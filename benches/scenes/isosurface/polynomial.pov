#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-3, 5, -8> * 100 rgb 1 }
isosurface {
  function { x*x*x*x + y*y*y*y + z*z*z*z - 1.2*(x*x + y*y + z*z) + 0.35 }
  contained_by { box { -1.5, 1.5 } } max_gradient 12
  pigment { rgb <0.8, 0.5, 0.3> }
}
