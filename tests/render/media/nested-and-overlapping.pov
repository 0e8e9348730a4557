// Containers inside and across each other: what is inside of several has the media of all.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7> look_at 0 right x*image_width/image_height angle 42 }
light_source { <-5, 8, -6> rgb 1 }
background { rgb <0.8, 0.85, 0.9> }
#declare Clear = texture { pigment { rgbt 1 } }
box { <-2.4, -1, -1>, <-0.2, 1, 1> hollow texture { Clear } interior { media { absorption <0.1, 0.3, 0.6> } } }
sphere { <-1.3, 0, 0>, 0.7 hollow texture { Clear } interior { media { emission <0.2, 0.5, 0.1> method 2 intervals 3 } } }
sphere { <0.9, 0, 0>, 0.9 hollow texture { Clear } interior { media { absorption <0.8, 0.2, 0.2> } } }
sphere { <1.7, 0.2, 0.3>, 0.9 hollow texture { Clear } interior { media { absorption <0.2, 0.2, 0.9> scattering { 1, 0.2 } } } }
sphere { <1.3, 0.1, 0.1>, 0.4 pigment { rgb <1, 0.8, 0.2> } }
cylinder { <1.3, -2, 0>, <1.3, 2, 0>, 0.25 texture { pigment { rgbt 0.8 } } }
