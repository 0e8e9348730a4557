// Texture coordinates of solids cut out of others, and what inherits.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0 angle 36 }
light_source { <-20, 30, -30> rgb 1 }
background { rgb 0.2 }

#declare Squares = pigment {
  uv_mapping
  checker
    pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.9, 0.8, 0.1>] } }
    pigment { gradient y color_map { [0 rgb <0.1, 0.2, 0.8>] [1 rgb <0.2, 0.9, 0.8>] } }
  scale <1/8, 1/6, 1>
}

difference {
  box { -0.9, 0.9 }
  sphere { <0.4, 0.6, -0.9>, 0.8 }
  cylinder { -2*x, 2*x, 0.4 pigment { Squares } }
  pigment { Squares }
  rotate <10, 30, 0>
  translate -1.3*x
}
union { sphere { 0, 0.7 } cone { y, 0.2, 1.5*y, 0.6 pigment { rgb 1 } } torus { 0.9, 0.2 pigment { Squares } } uv_mapping pigment { checker rgb 1 rgb x scale 0.1 } rotate -20*x translate 1.3*x }
