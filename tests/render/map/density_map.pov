// Densities: their own maps, lists and averages, colour maps, and turbulence, in emitting balls.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.0137, 0.0071, -10> direction z right x*8 up y*6 }
#declare Cells = 0;
#macro Cloud(D)
  sphere { 0, 0.95 pigment { rgbt 1 } hollow
    interior { media { emission 0.8 method 3 samples 5 intervals 1 density { D } } }
    translate <mod(Cells, 4)*2 - 3, 2 - 2*int(Cells/4), 0> }
  #declare Cells = Cells + 1;
#end
Cloud(density { spherical })
Cloud(density { spherical color_map { [0 rgb 0] [0.5 rgb <1, 0.4, 0.1>] [1 rgb <0.2, 0.3, 1>] } })
Cloud(density { spherical density_map { [0 rgb 0] [0.4 planar] [1 boxed] } })
Cloud(density { gradient x density_map { [0.2 spherical] [0.8 cylindrical color_map { [0 rgb 0] [1 rgb <1, 0.3, 0.2>] }] } })
Cloud(density { average density_map { [1 spherical] [2 boxed color_map { [0 rgb 0] [1 rgb <0.2, 1, 0.5>] }] } })
Cloud(density { checker density { spherical } density { rgb <0.6, 0.2, 0.1> } scale 0.5 })
Cloud(density { crackle solid density_map { [0.5 rgb 0] [0.5 boxed] } scale 0.4 })
Cloud(density { wood color_map { [0 rgb 0.2] [1 rgb <0.9, 0.6, 0.2>] } turbulence 0.1 scale 0.4 })
Cloud(density { bozo turbulence 0.5 scale 0.3 color_map { [0.4 rgb 0] [1 rgb <0.6, 0.8, 1>] } })
Cloud(density { spherical frequency 3 sine_wave })
Cloud(density { function { max(0, 1 - sqrt(x*x + y*y)) } })
Cloud(density { onion density_map { [0 rgb <0, 0.3, 0.6>] [1 spherical] } scale 0.5 })
