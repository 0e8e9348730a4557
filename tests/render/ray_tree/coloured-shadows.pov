// Filter and transmit colour the shadows; layers multiply.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }

plane { y, -0.6 pigment { rgb 0.9 } }
box { <-2.2, 0.5, -0.4>, <-1, 0.6, 0.8> pigment { rgbf <1, 0.2, 0.1, 0.9> } finish { diffuse 0.1 } }
box { <-0.8, 0.5, -0.4>, <0.4, 0.6, 0.8> pigment { rgbt <0.1, 0.4, 1, 0.6> } finish { diffuse 0.4 } }
box { <0.6, 0.5, -0.4>, <1.8, 0.6, 0.8>
  texture { pigment { rgbf <0.2, 0.9, 0.3, 0.8> } finish { diffuse 0.2 } }
  texture { pigment { rgbft <1, 1, 0.2, 0.3, 0.5> } finish { diffuse 0.2 } }
}
sphere { <0, 1.4, 0.5>, 0.3 pigment { rgb <0.8, 0.1, 0.6> } no_shadow }
