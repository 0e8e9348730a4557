// Textures as fine as the accuracy of the surface they are on.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at <0, 0.2, 0> right x*image_width/image_height angle 45 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }

isosurface {
  function { y - 0.2*sin(2*x)*cos(3*z) } max_gradient 1.3 contained_by { box { <-3, -1, -2>, <3, 1, 2> } }
  pigment { rgb <1, 0.9, 0.65> } normal { granite 0.2 scale 0.02 }
}
isosurface {
  function { x*x + y*y + z*z - 0.3 } max_gradient 3 accuracy 0.01 contained_by { box { -1, 1 } }
  pigment { checker rgb 0.9 rgb <0.6, 0.2, 0.1> scale 0.03 } scale 2 translate y
}
