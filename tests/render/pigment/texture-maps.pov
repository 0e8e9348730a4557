// Whole textures selected and blended by patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare Shiny = texture { pigment { rgb <0.8, 0.6, 0.2> } finish { reflection 0.4 specular 0.8 } }
#declare Matte = texture { pigment { rgb <0.2, 0.3, 0.6> } }
sphere { <-1.3, 0.3, 0>, 0.8 texture { gradient y texture_map { [0.3 Shiny] [0.7 Matte] } scale 0.6 } }
sphere { <0.2, 0.3, 0.8>, 0.8 texture { checker texture { Shiny } texture { Matte } scale 0.4 } }
box { <1, -0.5, -0.4>, <2, 0.6, 0.6> texture { average texture_map { [1 Shiny] [3 Matte] } } }
