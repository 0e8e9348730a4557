// povista-compat: +W80 +H60
// A smooth mesh unrolled: each pixel looks out of its place on the map.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Dome = mesh2 {
  vertex_vectors { 5, <-1, 0.2, -3>, <1, 0.2, -3>, <1, 1.6, -3>, <-1, 1.6, -3>, <0.1, 0.8, -3.4> }
  normal_vectors { 5, <-0.6, -0.4, 1>, <0.6, -0.4, 1>, <0.6, 0.4, 1>, <-0.6, 0.4, 1>, <0, -0.1, 1> }
  uv_vectors { 5, <0, 0>, <1.01, 0.01>, <1, 1.02>, <0.013, 1>, <0.51, 0.47> }
  face_indices { 4, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4> }
}
camera { mesh_camera { 1 3 mesh { Dome rotate -4*x } smooth } location <0, 0, -0.02> direction <0, 0, -1> }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

sphere { <-1, 0.2, 0>, 0.7 pigment { rgb <0.9, 0.4, 0.3> } }
box { <0.3, -0.6, -0.6>, <1.4, 0.6, 0.5> pigment { rgb <0.3, 0.5, 0.9> } }
cone { <0, -0.6, 2>, 0.7, <0, 1.6, 2>, 0 pigment { rgb <0.4, 0.8, 0.4> } }
