// Texture coordinates of meshes, with and without vectors.
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

mesh {
  triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0.3> uv_vectors <0, 0>, <1, 0>, <0.5, 1.5> }
  smooth_triangle { <-1, -1, 0>, <0, -0.5, -1>, <0, 1, 0.2>, y, <0.6, 1, -0.3>, <-0.7, 0.4, 0> uv_vectors <0.3, 0.2>, <1, 0.4>, <0, 1> }
  triangle { <1, -1, 0>, <1.4, 0.8, 0>, <0, 1, 0.3> }
  pigment { Squares }
  translate -1.3*x
}
mesh2 {
  vertex_vectors { 4, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0.5>, <-0.6, 1, -0.5> }
  uv_vectors { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
  uv_indices { 2, <0, 1, 2>, <0, 2, 3> }
  pigment { Squares }
  translate 1.3*x
}
