#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z aperture 1 blur_samples 2000000000 }
sphere { 0, 1 pigment { mandel 1000000000 } interior { dispersion_samples 1000000 media { samples 1, 1e9 intervals 1e9 aa_level 99 } } }
julia_fractal { <-0.1, 0.2, 0, 0> max_iteration 1e9 }
bicubic_patch { type 1 u_steps 99 v_steps 11
  <0,0,0> <1,0,0> <2,0,0> <3,0,0> <0,1,0> <1,1,0> <2,1,1> <3,1,0> <0,2,0> <1,2,0> <2,2,0> <3,2,0> <0,3,0> <1,3,0> <2,3,0> <3,3,0>
}
