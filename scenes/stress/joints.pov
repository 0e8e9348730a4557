// povista-compat: +H121
// Rays at the exact height of a joint: of a double cone from a `lathe`, of a hexagonal `prism` through
// two of its edges. POV-Ray counts such a joint twice or not at all. An odd number of rows puts one there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> direction z right 4*x up 3.025*y }
light_source { <-3, 5, -8> rgb 1 }
intersection {
  lathe { linear_spline 3, <0, -1>, <1, 0>, <0, 1> pigment { rgb <0.9, 0.2, 0.2> } }
  plane { -z, 0 pigment { rgb <0.3, 0.9, 0.4> } }
  scale 0.9 translate 1*x
}
prism {
  0, 1, 7, <1,0>, <0.5,0.875>, <-0.5,0.875>, <-1,0>, <-0.5,-0.875>, <0.5,-0.875>, <1,0>
  matrix <1,0,0, 0,0,-1, 0,1,0, 0,0,0> scale 0.9 translate -1*x pigment { rgb <1, 0.7, 0.3> }
}
