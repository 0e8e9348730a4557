// fade_distance and fade_power.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }

light_source { <-1.5, 0.8, -1> rgb <2, 1, 0.5> fade_distance 1 fade_power 2 }
light_source { <1.8, 0.6, 0.5> rgb <0.5, 1, 2> fade_distance 0.7 fade_power 3 }
plane { y, -0.6 pigment { rgb 0.9 } }
sphere { <0, 0.1, 0>, 0.5 pigment { rgb <0.9, 0.7, 0.5> } }
