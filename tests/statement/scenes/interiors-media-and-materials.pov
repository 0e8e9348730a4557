#version 3.7;
global_settings { assumed_gamma 1 }
#declare Glass = interior { ior 1.5 fade_distance 2 fade_power 1001 fade_color rgb <0, 1, 0> dispersion 1.02 caustics 0.5 }
#declare M = material { texture { pigment { rgbf 1 } } interior { Glass } scale 2 }
sphere { 0, 1 material { M } interior_texture { pigment { rgb 0 } } }
sphere {
  0, 1
  hollow
  interior {
    media {
      method 2 intervals 5 samples 2, 4 confidence 0.5 variance 0.1 ratio 0.8 jitter 0.5
      absorption rgb 0.1
      scattering { 5, rgb 0.5 eccentricity 0.3 extinction 0.8 }
      density { spherical density_map { [0 rgb 0] [1 granite] } scale 2 }
      density { rgb 0.5 }
      translate y
    }
  }
}
media { emission 0.1 }
