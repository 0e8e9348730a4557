// Densities by pattern, with maps of colours, densities and none, and products of two.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 right x*image_width/image_height angle 44 }
background { rgb <0.1, 0.12, 0.15> }

#declare Where = array[12] { <-3,2,0>, <-1,2,0>, <1,2,0>, <3,2,0>, <-3,0,0>, <-1,0,0>, <1,0,0>, <3,0,0>, <-3,-2,0>, <-1,-2,0>, <1,-2,0>, <3,-2,0> }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { spherical color_map { [0 rgb 0] [1 rgb <2, 1, 0.5>] } } } } translate Where[0] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { bozo scale 0.4 } } } translate Where[1] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { gradient y color_map { [0 rgb 0] [1 rgb x] } scale 0.5 turbulence 0.3 } } } translate Where[2] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { cylindrical ramp_wave } density { planar } } } translate Where[3] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { absorption 1.5 density { boxed color_map { [0 rgb 0] [1 rgb <0.4, 1, 0.6>] } } } } translate Where[4] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { granite color_map { [0 rgb 0] [1 rgb <0.4, 1, 1>] } scale 2 } samples 20 } } translate Where[5] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { onion density_map { [0 rgb 0] [0.5 gradient x scale 0.3] [1 rgb <0, 0.5, 1>] } } } } translate Where[6] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { spiral1 3 poly_wave 2 } } } translate Where[7] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { average density_map { [1 spherical] [2 crackle scale 0.4] } } } } translate Where[8] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.6 density { function { x*x + y*y } color_map { [0 rgb 1] [1 rgb 0] } } } } translate Where[9] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission <1, 0.5, 0.2> density { wood turbulence 0.1 scale 0.5 color_map { [0 rgb 0.2] [1 rgb 1] } } } } translate Where[10] }
sphere { 0, 0.95 hollow pigment { rgbt 1 } interior { media { emission 0.4 density { leopard scale 0.2 frequency 2 } density { rgb <1, 0.7, 0.3> } } } translate Where[11] }
