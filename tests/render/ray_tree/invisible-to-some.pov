// no_image, no_reflection and no_shadow each hide an object from one kind of ray only.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

plane { -z, -4 pigment { rgb 0 } finish { reflection 0.8 } }
sphere { <-1.5, 0.2, 0>, 0.6 pigment { rgb <1, 0.3, 0.2> } no_image }
sphere { <0, 0.2, 0>, 0.6 pigment { rgb <0.3, 1, 0.2> } no_reflection }
sphere { <1.5, 0.2, 0>, 0.6 pigment { rgb <0.3, 0.2, 1> } no_shadow }
