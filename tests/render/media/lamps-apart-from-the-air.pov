// media_interaction and media_attenuation: lamps that the air lets alone, and that it dims.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> look_at <0, 1, 0> right x*image_width/image_height angle 45 }
light_source { <-3, 5, 0> rgb <1.2, 0.5, 0.3> spotlight point_at <-1.5, 0, 0> radius 12 falloff 18 media_interaction off }
light_source { <0, 5, 0> rgb <0.4, 1.2, 0.5> spotlight point_at <0, 0, 0> radius 12 falloff 18 media_attenuation on }
light_source { <3, 5, 0> rgb <0.3, 0.5, 1.2> spotlight point_at <1.5, 0, 0> radius 12 falloff 18 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <0, 0.6, 0>, 0.4 pigment { rgb <0.9, 0.8, 0.7> } }
fog { distance 30 rgb <0.2, 0.25, 0.3> }
media { scattering { 1, rgb 0.05 } absorption 0.02 intervals 4 samples 4 method 3 }
