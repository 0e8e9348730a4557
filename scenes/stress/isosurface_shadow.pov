// Waves whose steepness POV-Ray is told too low, and a coarse `accuracy`: holes, and shadows that eat
// the surface they fall on.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -3> look_at 0 angle 45 }
light_source { <-4, 3, -2> rgb 1 }
plane { y, -1 pigment { rgb 0.6 } }
isosurface {
  function { x*x + y*y + z*z - 1 + 0.2*sin(10*x)*sin(10*y)*sin(10*z) }
  max_gradient 2.2 accuracy 0.01
  contained_by { box { -1.5, 1.5 } }
  pigment { rgb <0.9, 0.75, 0.4> }
}
