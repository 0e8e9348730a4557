#version 3.7;
global_settings { assumed_gamma 1 }
sphere {
  0, 1
  pigment { gradient x }
  translate y
  normal { bumps 0.3 }
  interior { media { emission 1 density { spherical } } }
  clipped_by { plane { y, 0 } }
  rotate z*90
}
// The texture of a uv-mapped object stays where it is.
torus { 1, 0.2 uv_mapping pigment { checker } scale 2 }
