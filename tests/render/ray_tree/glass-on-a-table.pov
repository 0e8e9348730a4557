// Glass that stands exactly on the ground, declared before it: the ground is seen through it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -5> look_at <0, 0.5, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }

#declare Glass = texture { pigment { rgbf 1 } finish { reflection 0.1 specular 0.4 } }

box { <-2.2, 0, -0.6>, <-1, 1.2, 0.6> texture { Glass } interior { ior 1.5 } }
box { <-0.6, 0, -0.6>, <0.6, 1, 0.6> pigment { rgbf <1, 0.3, 0.2, 0.8> } }
difference {
  box { <1, 0, -0.6>, <2.2, 1.2, 0.6> }
  box { <1.2, 0.3, -0.4>, <2, 2, 0.4> }
  texture { Glass } interior { ior 1.3 }
}
plane { y, 0 pigment { checker rgb 1, rgb <0.1, 0.5, 0.2> scale 0.4 } }
