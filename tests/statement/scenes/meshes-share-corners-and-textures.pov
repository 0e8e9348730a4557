#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = texture { pigment { rgb 1 } }
#declare B = texture { pigment { rgb 0 } }
mesh {
  triangle { 0, x, y uv_vectors <0, 0>, <1, 0>, <0, 1> texture { A } }
  triangle { x, y, x + y texture_list { A, B, A } }
  triangle { 0, x, 2*x }
  smooth_triangle { 0, z, x, z, -y, z }
  inside_vector y
}
mesh2 {
  vertex_vectors { 4, 0, x, y, x + y }
  normal_vectors { 4, z, z, z, z }
  uv_vectors { 2, <0, 0>, <1, 1> }
  texture_list { 2, texture { A }, texture { B } }
  face_indices { 2, <0, 1, 2>, 0, <1, 2, 3>, 0, 1, 1 }
  uv_indices { 2, <0, 1, 0>, <1, 0, 1> }
}
