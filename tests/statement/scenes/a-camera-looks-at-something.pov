#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  up 3*y
  direction 2*z
  rotate z*90
  look_at <0.5, 0, 1>
  location <1, 2, -3>
  angle 60
  aperture 0.4 blur_samples 4, 9 focal_point <0, 0, 2>
}
sphere { 0, 1 }
