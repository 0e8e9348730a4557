// Lights that reach only their own group.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }

light_source { <-4, 5, -5> rgb 0.4 }
light_group {
  light_source { <3, 3, -3> rgb <1, 0.3, 0.2> }
  sphere { <-1.2, 0.1, 0>, 0.5 pigment { rgb 0.9 } }
  global_lights on
}
light_group {
  light_source { <3, 3, -3> rgb <0.2, 0.3, 1> }
  sphere { <1.2, 0.1, 0>, 0.5 pigment { rgb 0.9 } }
}
plane { y, -0.6 pigment { rgb 0.9 } }
sphere { <0, 0.1, 0>, 0.5 pigment { rgb <0.9, 0.7, 0.5> } }
