// Texture coordinates of a height field, which has no coordinates of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0 angle 35 }
light_source { <-20, 30, -30> rgb 1 }
background { rgb 0.2 }

#declare Squares = pigment {
  uv_mapping
  checker
    pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.9, 0.8, 0.1>] } }
    pigment { gradient y color_map { [0 rgb <0.1, 0.2, 0.8>] [1 rgb <0.2, 0.9, 0.8>] } }
  scale <1/8, 1/6, 1>
}

height_field {
  function 30, 20 { 0.5 + 0.3*sin(9*x)*cos(7*y) } smooth
  pigment { Squares }
  translate <-0.5, 0, -0.5>
  scale <3, 1, 3>
}
