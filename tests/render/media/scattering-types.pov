// The five kinds of scattering, lit from behind and from the side.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -9> look_at 0 right x*image_width/image_height angle 40 }
light_source { <3, 4, 6> rgb 0.8 }
light_source { <-6, 3, -3> rgb <0.4, 0.5, 0.9> }
background { rgb <0.05, 0.06, 0.1> }

