// Methods 2 and 3 with samples, intervals and adaptive settings, where nothing is random.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 right x*image_width/image_height angle 44 }
background { rgb <0.1, 0.12, 0.15> }
light_source { <-6, 5, -4> rgb 0.9 }
#declare Puff = density { spherical scale 0.95 color_map { [0 rgb 0] [0.4 rgb 0] [0.4 rgb 2] [1 rgb <1, 2, 4>] } }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { method 2 samples 3 emission 0.1 absorption 0.2 scattering { 1, 0.3 } density { Puff } } } translate <-3, 1.1, 0> }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { method 2 samples 5 intervals 4 emission 0.1 absorption 0.2 scattering { 1, 0.3 } density { Puff } } } translate <-1, 1.1, 0> }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { method 3 samples 4 emission 0.1 absorption 0.2 scattering { 1, 0.3 } density { Puff } } } translate <1, 1.1, 0> }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { method 3 samples 4 aa_level 6 aa_threshold 0.01 emission 0.1 absorption 0.2 scattering { 1, 0.3 } density { Puff } } } translate <3, 1.1, 0> }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { method 3 samples 12 intervals 3 ratio 0.5 emission 0.1 absorption 0.2 scattering { 1, 0.3 } density { Puff } } } translate <-3, -1.1, 0> }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { method 3 samples 1 aa_level 1 emission 0.1 absorption 0.2 scattering { 1, 0.3 } density { Puff } } } translate <-1, -1.1, 0> }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { method 3 samples 6 intervals 7 aa_threshold 1 emission 0.1 absorption 0.2 scattering { 1, 0.3 } density { Puff } } } translate <1, -1.1, 0> }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { method 2 samples 8 intervals 1 emission 0.1 absorption 0.2 scattering { 1, 0.3 } density { Puff } } } translate <3, -1.1, 0> }
