// Densities follow the transforms of media, objects and compounds.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.6, -7> look_at 0 right x*image_width/image_height angle 44 }
background { rgb <0.1, 0.12, 0.18> }
#declare Stripes = media { emission 0.5 density { gradient x sine_wave scale 0.5 } rotate 20*z }
#declare Puff = sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { Stripes } } }
object { Puff translate <-2, 0.5, 0> }
object { Puff scale <0.6, 1, 0.6> rotate -40*z translate <2, 0.5, 0> }
union {
  object { Puff scale 0.6 translate 0.8*y }
  box { -0.5, 0.5 hollow pigment { rgbt 1 } interior { media { Stripes scale 0.5 } } rotate 30*y translate -0.6*y }
  rotate 10*z
}
intersection {
  sphere { 0, 0.7 }
  box { -0.55, 0.55 }
  hollow pigment { rgbt 1 }
  interior { media { emission <0, 0.6, 0.8> density { spherical scale 0.9 } } media { emission <0.6, 0.1, 0> density { planar } } }
  rotate <30, 40, 0> translate <2, -1.4, 0>
}
