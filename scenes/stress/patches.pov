// A bicubic patch whose pieces are cut to a given flatness: where a fine piece borders on a coarse
// one POV-Ray's surface has cracks. And smooth triangles with normals on both sides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> direction z right 3.2*x up 2.4*y }
light_source { <-3, 5, -8> rgb 1 shadowless }
background { rgb <1, 1, 1> }
bicubic_patch {
  type 1 flatness 0.1 u_steps 5 v_steps 5
  <-1,-1,0.5>, <-0.3,-1,-0.5>, <0.3,-1,0.5>, <1,-1,0>,
  <-1,-0.3,0>, <-0.3,-0.3,-1>, <0.3,-0.3,0.5>, <1,-0.3,0>,
  <-1,0.3,0>, <-0.3,0.3,0.5>, <0.3,0.3,-1>, <1,0.3,0>,
  <-1,1,0>, <-0.3,1,0>, <0.3,1,0>, <1,1,0.5>
  rotate <50, 20, 0> translate -0.4*x
  pigment { rgb <0.2, 0.3, 0.7> }
}
smooth_triangle {
  <0.8, -0.9, 0>, <0, 0.2, -1>, <1.5, -0.9, 0>, <0.3, 0.1, 1>, <1.15, 0.9, 0>, <0, 0.5, -1>
  pigment { rgb <0.9, 0.4, 0.3> }
}
