// Texture coordinates of tori.
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

torus { 0.7, 0.3 pigment { Squares } rotate <-30, 30, 0> translate -1.2*x }
torus { 0.6, 0.35 pigment { Squares } rotate <60, 200, 0> translate 1.2*x }
