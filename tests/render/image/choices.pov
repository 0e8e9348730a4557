// Textures chosen by an image, and patterns that are images.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 angle 40 }
light_source { <-20, 30, -30> rgb 1 }
background { rgb 0.3 }
plane { y, -2 pigment { rgb 0.5 } }

#declare Choice = texture {
  material_map {
    png "palette.png"
    texture { pigment { rgb x } }
    texture { pigment { checker rgb 1 rgb 0 scale 0.1 } }
    texture { pigment { rgb y } finish { specular 0.8 } }
    texture { pigment { gradient y scale 0.2 } }
  }
}
box { -0.8, 0.8 texture { Choice rotate 10*y } translate <-2, 1, 0> }
sphere { 0, 0.9 texture { material_map { png "soft.png" map_type 1 texture { pigment { rgb x } } texture { pigment { rgb y } } texture { pigment { rgb z } } } } translate y }
box { -0.8, 0.8 pigment { image_pattern { png "soft.png" use_alpha interpolate 2 } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } } translate <2, 1, 0> }
sphere { 0, 0.8 pigment { image_pattern { png "palette.png" map_type 1 } color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0>] [1 rgb 1] } frequency 2 } translate <-2, -1, 0> }
box { -0.8, 0.8 texture { image_pattern { pgm "hills.pgm" interpolate 3 once } texture_map { [0.4 pigment { rgb <0.2, 0.4, 0.9> }] [0.6 pigment { rgb <0.9, 0.8, 0.6> }] } scale 1.4 translate -0.7 } translate -y }
cylinder { -0.8*y, 0.8*y, 0.7 pigment { image_pattern { function 24, 24 { x*y } map_type 2 } pigment_map { [0 checker rgb 1 rgb x scale 0.2] [1 rgb z] } } translate <2, -1, 0> }
