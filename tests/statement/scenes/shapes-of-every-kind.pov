#version 3.7;
global_settings { assumed_gamma 1 }
box { <1, -1, 1>, -1 }
cone { 0, 1, y, 0.5 open }
cylinder { 0, y, 1 }
plane { 2*y, -1 }
disc { 0, 2*z, 1, 0.5 }
torus { 2, 0.5 sturm }
triangle { 0, x, y }
smooth_triangle { 0, z, x, z, y, z }
polygon { 5, 0, x, x + y, y, 0 }
quadric { <1, 1, 1>, 0, <0, 0, 1>, -1 }
quartic { <1,0,0,0,2,0,0,2,0,-2.5,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.5,0,0,0,0,1,0,-2.5,0,0.5> }
polynomial { 2, xyz(2, 0, 0): 1, xyz(0, 2, 0): 1, xyz(0, 0, 0): -1 }
superellipsoid { <0.25, 1> }
ovus { 1, 0.5 }
bicubic_patch {
  type 1 u_steps 3 v_steps 2
  <0,0,0>, <1,0,0>, <2,0,0>, <3,0,0>, <0,1,0>, <1,1,1>, <2,1,1>, <3,1,0>
  <0,2,0>, <1,2,1>, <2,2,1>, <3,2,0>, <0,3,0>, <1,3,0>, <2,3,0>, <3,3,0>
}
blob {
  threshold 0.6
  sphere { 0, 1, 2 translate x }
  cylinder { 0, y, 1, strength -1 pigment { rgb 1 } }
  component 1, 0.5, z
}
height_field { function 8, 8 { x*y } smooth water_level 0.1 }
isosurface {
  function { x*x + y*y + z*z - 1 }
  contained_by { sphere { 0, 2 } }
  max_gradient 4 accuracy 0.01 evaluate 1, 2, 0.5 all_intersections open
}
julia_fractal { <-0.1, 0.8, 0, 0> hypercomplex pwr(2, 1) max_iteration 8 slice <0, 0, 0.5, 1>, 0.1 }
lathe { cubic_spline 4, <0, 0>, <1, 1>, <0.5, 2>, <0, 3> }
prism { conic_sweep linear_spline 1, 0, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> open }
sor { 4, <0, 0>, <1, 1>, <0.5, 2>, <0, 3> open }
sphere_sweep { b_spline 4, 0, 1, x, 0.5, 2*x, 1, 3*x, 1 tolerance 0.01 }
text { internal 1 "Aé", 0.3, 0.1*x }
parametric { function { u } function { v } function { sin(u*v) } <0, 0>, <1, 2> precompute 8, x, z }
