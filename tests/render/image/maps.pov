// Images laid flat, around a sphere, a cylinder and a torus; read between pixels; once and repeated.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 angle 40 }
light_source { <-20, 30, -30> rgb 1 }
background { rgb 0.3 }
plane { y, -2 pigment { rgb 0.5 } }

box { -0.8, 0.8 pigment { image_map { png "soft.png" interpolate 2 } scale 1.2 rotate 20*y } translate <-2, 1, 0> }
sphere { 0, 0.9 pigment { image_map { png "palette.png" map_type 1 } } rotate -30*x translate <0, 1, 0> }
cylinder { -0.8*y, 0.8*y, 0.8 pigment { image_map { png "soft.png" map_type 2 interpolate 3 } translate -0.5*y scale 1.6 } translate <2, 1, 0> }
torus { 1, 0.4 pigment { image_map { png "palette.png" map_type 5 interpolate 4 repeat <3, 2> } } rotate -60*x scale 0.6 translate <-2, -1, 0> }
plane { z, 0.5 clipped_by { box { <-1, -1, 0>, 1 } } pigment { image_map { png "palette.png" once filter 3, 0.7 transmit 1, 0.4 } translate -0.5 scale <1.6, 1, 1> } translate -y }
sphere { 0, 0.8 pigment { image_map { png "soft.png" premultiplied on map_type 1 once interpolate 2 repeat <0.5, 1> } } translate <2, -1, 0> }
