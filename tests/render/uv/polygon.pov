// Texture coordinates of a polygon and triangles.
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

polygon { 5, <-1, -1, 0>, <1, -1, 0.2>, <1, 1, 0.4>, <-1, 1, 0.2>, <-1, -1, 0> pigment { Squares } translate -1.3*x }
triangle { <0.5, -1, 0>, <2.5, -1, 0.5>, <1, 1, 0> pigment { Squares } }
smooth_triangle { <2.2, -0.5, 0>, y, <2.5, 1, 0.5>, -z, <1.2, 1, 0>, x pigment { Squares } }
