// Grids of lamps that are moved at random.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0, 0> right x*image_width/image_height angle 50 }
light_source { <-4, 5, -2> rgb <0.5, 0.3, 0.2> area_light 2*x, 2*z, 4, 3 jitter }
light_source { <4, 5, -2> rgb <0.2, 0.4, 0.6> area_light 2*x, 2*z, 9, 9 adaptive 1 jitter circular orient }
plane { y, -0.6 pigment { rgb 0.9 } }
sphere { <-1.2, 0.2, 0>, 0.6 pigment { rgb <0.9, 0.7, 0.5> } finish { crand 0.2 } }
box { <0.5, -0.6, -0.4>, <1.5, 0.8, 0.6> pigment { rgb <0.5, 0.7, 0.9> } }
