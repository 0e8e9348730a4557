// A glowing cloud seen through a lens, in a mirror, and inside coloured glass that filters its light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 0.8, -6> look_at 0 right x*image_width/image_height angle 44 }
light_source { <-5, 8, -6> rgb 1 }
background { rgb <0.05, 0.06, 0.1> }
plane { y, -1 hollow pigment { rgb 0.4 } finish { reflection 0.4 } }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { emission <1.2, 0.5, 0.1> density { spherical } } } translate <0, 0, 2> }
sphere { 0, 0.7 scale <1, 1, 0.4> hollow pigment { rgbf 1 } finish { specular 0.6 } interior { ior 1.5 } translate <0.1, 0, 0> }
box { -0.5, 0.5 hollow pigment { rgbf <0.6, 0.9, 1, 0.9> } finish { reflection 0.1 }
  interior { media { scattering { 1, 0.6 } samples 5 } ior 1.1 } rotate 30*y translate <-1.8, -0.4, 0.3> }
cylinder { -0.6*y, 0.5*y, 0.5 hollow pigment { rgbf <1, 0.9, 0.6, 0.95> }
  interior { media { emission 0.4 absorption 0.5 density { cylindrical scale 0.5 } } fade_distance 1 fade_power 2 fade_color <1, 0.5, 0.2> } translate <1.8, -0.3, 0.3> }
