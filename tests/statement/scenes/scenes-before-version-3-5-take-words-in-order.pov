#version 3.0
camera { location <0, 0, -5> look_at 0 translate x }
sphere {
  0, 1
  texture { pigment { color red 1 filter 0.5 } finish { ior 1.5 refraction 1 } }
  texture { pigment { rgbf <0, 1, 0, 0.5> } }
}
height_field { function 4, 4 { x } water_level 0.5 }
