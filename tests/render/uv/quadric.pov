// Texture coordinates of quadrics and polynomials.
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

quadric { <1, 0.5, 1>, <0.2, 0, 0.1>, 0, -0.7 pigment { Squares } translate -1.3*x }
quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -1.24, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0.76, 0, 0, 0, 0, 1, 0, -1.24, 0, 0.1444> pigment { Squares } rotate 40*x translate 1.3*x }
