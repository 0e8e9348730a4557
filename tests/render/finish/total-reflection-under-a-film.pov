// irid where light is totally reflected inside glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.3, 0> right x*image_width/image_height angle 40 }
light_source { <-6, 8, 7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

box { -0.7, 0.7 rotate <40, 30, 0> translate <-1, 0.4, 0>
  pigment { rgbf 1 } finish { irid { 0.6 thickness 0.8 } } interior { ior 1.5 } }
torus { 0.6, 0.25 rotate 60*x translate <1, 0.3, 0>
  pigment { rgbf 1 } finish { irid { 0.5 thickness 0.4 turbulence 0.2 } } interior { ior 1.45 } }
