// Media dim lamps: a cloud's shadow on the ground, and a dense ball that shades itself.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 0.4, 0> right x*image_width/image_height angle 42 }
light_source { <-3, 6, -2> rgb 1 }
background { rgb <0.3, 0.45, 0.7> }
plane { y, -1 hollow pigment { checker rgb 0.9 rgb 0.6 } }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { absorption <1, 2, 3> density { spherical } } } translate <-1.4, 0.7, 0> }
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, 1.5 } density { spherical poly_wave 0.5 } samples 6 } } translate <1.4, 0.6, 0> }
box { <-0.3, -1, -2>, <0.3, 0, -1.4> hollow pigment { rgbt 1 } interior { media { method 2 absorption 2 density { gradient y } } } }
