// Spotlights and a cylinder of light in dusty air, with a shadow through a cone.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -8> look_at <0, 1, 0> right x*image_width/image_height angle 50 }
light_source { <-3, 4, 1> rgb <1.6, 1, 0.6> spotlight point_at <-1, 0, 0> radius 12 falloff 16 tightness 0 media_attenuation on }
light_source { <3, 4, -1> rgb <0.6, 1, 1.6> spotlight point_at <1, 0, 0> radius 5 falloff 20 }
light_source { <0, 5, 2> rgb <0.5, 1.2, 0.5> cylinder point_at <0.2, 0, 2> radius 0.4 falloff 0.6 tightness 0 }
light_source { <0, 6, -8> rgb 0.15 media_interaction off }
box { <-12, -1, -12>, <12, 9, 12> hollow pigment { rgb 0.6 } }
sphere { <-1.9, 2.2, 0.5>, 0.35 pigment { rgb <0.9, 0.3, 0.2> } }
media { scattering { 1, 0.04 extinction 0.6 } samples 8 intervals 5 }
