// The same wavy ball with max_gradient right, too low, and as it is by default. POV-Ray's second and third one
// have holes or are gone.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 45 }
light_source { <-3, 5, -8> * 100 rgb 1 }
#declare Wavy = function { x*x + y*y + z*z - 0.4 + 0.1*sin(14*x)*sin(14*y)*sin(14*z) }
isosurface {
  function { Wavy(x, y, z) } contained_by { box { -0.8, 0.8 } } max_gradient 6
  pigment { rgb <0.8, 0.5, 0.3> } translate -1.6*x
}
isosurface {
  function { Wavy(x, y, z) } contained_by { box { -0.8, 0.8 } } max_gradient 0.7
  pigment { rgb <0.8, 0.5, 0.3> }
}
isosurface {
  function { Wavy(x, y, z) } contained_by { box { -0.8, 0.8 } }
  pigment { rgb <0.8, 0.5, 0.3> } translate 1.6*x
}
