// A spring whose functions are fifty times as steep as max_gradient says: POV-Ray's is dashed.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -4> look_at 0 angle 40 }
light_source { <-3, 5, -8> * 100 rgb 1 }
parametric {
  function { (0.7 + 0.15*cos(v))*cos(50*u) }
  function { 2*u - 1 + 0.15*sin(v) }
  function { (0.7 + 0.15*cos(v))*sin(50*u) }
  <0, 0>, <1, 2*pi>
  contained_by { box { -1.3, 1.3 } }
  max_gradient 1 accuracy 0.001
  pigment { rgb <0.8, 0.8, 0.3> }
}
