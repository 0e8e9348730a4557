// Bumps from images: colours and indices, every projection.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 angle 40 }
light_source { <-20, 30, -30> rgb 1 }
background { rgb 0.3 }
plane { y, -2 pigment { rgb 0.5 } }

#default { pigment { rgb <0.7, 0.6, 0.5> } finish { specular 0.4 } }
box { -0.8, 0.8 normal { bump_map { png "soft.png" bump_size 3 interpolate 2 } } rotate 20*y translate <-2, 1, 0> }
sphere { 0, 0.9 normal { bump_map { png "palette.png" map_type 1 use_index bump_size 0.5 } } translate y }
cylinder { -0.8*y, 0.8*y, 0.8 normal { bump_map { png "palette.png" map_type 2 use_color bump_size -4 interpolate 3 } } translate <2, 1, 0> }
torus { 0.6, 0.25 normal { bump_map { pgm "hills.pgm" map_type 5 bump_size 4 interpolate 2 } } rotate -60*x translate <-2, -1, 0> }
box { -0.8, 0.8 normal { bump_map { function 32, 32 { sin(20*x)*sin(20*y) } once bump_size 2 } scale 1.3 translate -0.65 } rotate -20*x translate -y }
sphere { 0, 0.8 normal { image_pattern { pgm "hills.pgm" map_type 1 interpolate 2 } 1.5 } translate <2, -1, 0> }
