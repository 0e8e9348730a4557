#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-3, 5, -8> * 100 rgb 1 }
isosurface {
  function { x*x + y*y + z*z - 1.2 + 0.15*sin(9*x)*sin(9*y)*sin(9*z) }
  contained_by { sphere { 0, 1.5 } } max_gradient 6
  pigment { rgb <0.4, 0.7, 0.4> }
}
