// height_field of a number, of a pigment and with the scene's noise; smooth ones stretched unevenly.
#version 3.7;
global_settings { assumed_gamma 1 noise_generator 1 }
camera { location <0, 4, -5> look_at <0, 0, 0> right x*image_width/image_height angle 45 }
light_source { <-6, 8, -7> rgb 1 }
#default { pigment { rgb 0.8 } finish { specular 0.5 } }

height_field { function 40, 40 { x*x*0.5 + y*0.3 } smooth translate -0.5 scale <2, 1, 1.5> translate <-1.2, 0, 1> }
height_field { function 60, 60 { pigment { bozo scale 0.2 } } smooth translate -0.5 scale <2, 0.5, 1.5> translate <1.2, 0, 1> }
height_field {
  function 50, 50 { pigment { granite scale 0.6 color_map { [0 rgb <0.2, 0.5, 0.1>] [1 rgb <0.9, 0.3, 0.6>] } } }
  translate -0.5 scale <2, 0.6, 1.5> translate <-1.2, 0, -1>
}
height_field { function 9, 9 { pigment { gradient x } } water_level 0.3 smooth translate -0.5 scale <2, 1, 1.5> translate <1.2, 0, -1> }
