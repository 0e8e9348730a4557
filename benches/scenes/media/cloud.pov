// A cloud of noise that throws its own shadow, and a flame.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,1,-7> look_at 0 angle 45 }
background { rgb <0.3,0.5,0.8> }
light_source { <-5,8,-5> rgb 1 }
plane { y, -2 pigment { rgb <0.5,0.7,0.4> } }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, 2 extinction 0.8 } samples 12
  density { spherical density_map { [0 rgb 0] [0.4 rgb 0.7] [1 rgb 1] } }
  density { bozo turbulence 0.6 octaves 5 scale 0.5 density_map { [0.3 rgb 0] [0.6 rgb 1] } } } }
  scale 1.3 translate -0.9*x }
cylinder { -y, y, 0.6 hollow pigment { rgbt 1 } interior { media { emission <1.6,0.8,0.3> intervals 2
  density { cylindrical turbulence 0.4 density_map { [0 rgb 0] [0.5 rgb 0.5] [1 rgb 1] } }
  density { granite scale 2 } } } translate 1.7*x }
