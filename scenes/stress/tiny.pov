// The same nine things in a scene a millionth in size: camera and light are scaled along, so the
// picture has to be the same whatever the size.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = 1e-6;
camera { orthographic location <0, 0, -10>*S direction z right 8*x*S up 6*y*S }
light_source { <-6, 8, -10>*S rgb 1 }
#macro Put(Thing, X, Y, Color) object { Thing translate <X, Y, 0> scale S pigment { rgb Color } } #end
Put(sphere { 0, 0.8 }, -3, 2, <1, 0.4, 0.3>)
Put(torus { 0.6, 0.2 rotate 60*x }, -1, 2, <1, 0.7, 0.2>)
Put(quartic {
  <1,0,0,0,2,0,0,2,0,-1.25, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1,0,0,0,0, 1,0,-1.25,0,0.25>
  rotate 60*x scale 0.8 }, 1, 2, <0.8, 0.9, 0.3>)
Put(ovus { 0.55, 0.35 translate -0.2*y }, 3, 2, <0.4, 0.9, 0.4>)
Put(sphere_sweep {
  b_spline 5, <-1.5,-1,0>, 0.3, <-0.7,0,0>, 0.4, <0,0.8,0>, 0.3, <0.8,0,0.2>, 0.5, <1.5,-1,0>, 0.3
  scale 0.8 }, -2.6, 0, <0.3, 0.8, 0.8>)
Put(blob { threshold 0.4 sphere { <-0.4,0,0>, 0.9, 1 } sphere { <0.4,0.3,0>, 0.8, 1 } scale 0.8 }, 0, 0, <0.3, 0.5, 1>)
Put(isosurface {
  function { x*x*x*x + y*y*y*y + z*z - 0.6 } max_gradient 4.5 contained_by { box { -1, 1 } }
  scale 0.8 }, 2.6, 0, <0.6, 0.4, 1>)
Put(lathe {
  cubic_spline 6, <0.1,-1.5>, <0.4,-1>, <0.9,-0.2>, <0.5,0.5>, <0.2,1>, <0,2> scale 0.8
  rotate -20*x }, -2, -2, <0.9, 0.4, 0.9>)
Put(julia_fractal { <-0.083,0,-0.83,-0.025> quaternion sqr max_iteration 6 precision 20 scale 0.7 }, 2, -2, <0.9, 0.5, 0.6>)
