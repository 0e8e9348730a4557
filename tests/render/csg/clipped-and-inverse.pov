// clipped_by opens a solid, inverse turns it inside out, interior_texture shows inside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

sphere { <-1.3, 0.3, 0>, 0.9
  texture { pigment { rgb <0.9, 0.5, 0.2> } }
  interior_texture { pigment { rgb <0.2, 0.6, 0.9> } finish { ambient 0.3 } }
  clipped_by { plane { <0.3, 1, -0.4>, 0.3 } }
}
intersection {
  sphere { 0, 0.9 }
  cylinder { -2*z, 2*z, 0.4 inverse }
  plane { y, 0.5 }
  pigment { rgb <0.5, 0.8, 0.3> }
  rotate 25*y
  translate <1.2, 0.3, 0>
}
