// What is turned inside out is looked for in its box: it takes no fog from a camera beside it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> right x*image_width/image_height angle 45 }
light_source { <5, 8, -5> rgb 1 }
fog { distance 12 rgb <0.5, 0.6, 0.8> }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.4 } }
sphere { <-2, 0, 0>, 0.8 inverse pigment { rgb <0.9, 0.4, 0.3> } }
merge { sphere { 0, 0.7 } box { -0.6, 0.6 } inverse pigment { rgbf <0.4, 0.9, 0.3, 0.7> } interior { fade_distance 1 fade_power 1 } }
union { cylinder { <2, -0.9, 0>, <2, 0.6, 0>, 0.5 inverse } pigment { rgbf <0.4, 0.5, 0.9, 0.8> } interior { ior 1.3 } }
