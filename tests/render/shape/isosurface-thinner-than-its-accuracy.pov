// A bubble a thousandth thick, cut open, and a wire: POV-Ray's accuracy of 0.01 loses most of both.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.8, -4> look_at 0 angle 45 }
light_source { <-3, 5, -8> * 100 rgb 1 }
isosurface {
  function { abs(sqrt(x*x + y*y + z*z) - 1) - 0.0005 }
  contained_by { box { <-1.1, -1.1, -1.1>, <1.1, 0.3, 1.1> } }
  accuracy 0.01 max_gradient 1.1 max_trace 10
  pigment { rgb <0.5, 0.7, 0.9> }
}
isosurface {
  function { sqrt(pow(x - 0.3*sin(8*y), 2) + pow(z, 2)) - 0.02 }
  contained_by { box { <-0.5, -1.2, -0.2>, <0.5, 1.2, 0.2> } }
  accuracy 0.1 max_gradient 3
  pigment { rgb <0.9, 0.6, 0.3> }
}
