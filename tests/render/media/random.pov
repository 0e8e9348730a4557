// Methods with random samples: method 1, and jitter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -8> look_at 0 right x*image_width/image_height angle 40 }
background { rgb <0.1, 0.12, 0.15> }
light_source { <-6, 5, -4> rgb 0.9 }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { method 1 samples 8, 20 intervals 2 emission 0.3 density { spherical } } } translate <-1.1, 1.1, 0> }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { method 2 samples 6 jitter 0.7 emission 0.3 density { spherical } } } translate <1.1, 1.1, 0> }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { method 3 samples 10 jitter 1 scattering { 1, 0.3 } } } translate <-1.1, -1.1, 0> }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { method 2 samples 4, 12 variance 0.0001 emission 0.3 absorption 0.3 density { gradient y sine_wave } } } translate <1.1, -1.1, 0> }
