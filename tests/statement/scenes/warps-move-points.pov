#version 3.7;
global_settings { assumed_gamma 1 }
sphere {
  0, 1
  pigment {
    gradient x
    turbulence 0.5 octaves 3
    rotate z*90
    translate x
    warp { repeat x offset y flip x }
    warp { turbulence <0, 1, 0> omega 0.3 lambda 3 }
    warp { black_hole <1, 1, 1>, 0.5 strength 2 falloff 3 inverse repeat <3, 3, 3> turbulence 0.1 }
    warp { spherical orientation 2*y dist_exp 1 }
    warp { cylindrical }
    warp { toroidal major_radius 2 }
    warp { planar y, 2 }
    warp { cubic }
    matrix <1, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0>
  }
}
