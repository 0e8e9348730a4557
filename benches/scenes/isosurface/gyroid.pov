#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-3, 5, -8> * 100 rgb 1 }
isosurface {
  function { sin(6*x)*cos(6*y) + sin(6*y)*cos(6*z) + sin(6*z)*cos(6*x) }
  contained_by { sphere { 0, 1.3 } } max_gradient 12
  pigment { rgb <0.8, 0.8, 0.4> }
}
