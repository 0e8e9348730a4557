// Heights from images of 16 and 8 bits, grey and with a palette.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 angle 40 }
light_source { <-20, 30, -30> rgb 1 }
background { rgb 0.3 }
plane { y, -2 pigment { rgb 0.5 } }

height_field { pgm "hills.pgm" smooth pigment { rgb <0.5, 0.7, 0.4> } translate -0.5 scale <2.4, 1, 2> translate <-1.4, 0.6, 1> }
height_field { pgm "hills.pgm" water_level 0.45 pigment { rgb <0.8, 0.7, 0.4> } translate -0.5 scale <2.4, 1, 2> translate <1.4, 0.6, 1> }
height_field { png "palette.png" pigment { image_map { png "palette.png" } rotate 90*x } translate -0.5 scale <2.4, 20, 2> translate <-1.4, 8.5, -1.2> }
height_field { png "soft.png" smooth pigment { rgb <0.8, 0.5, 0.4> } translate -0.5 scale <2.4, 1, 2> translate <1.4, -1.2, -1.2> }
