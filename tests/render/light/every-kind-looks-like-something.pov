// looks_like and projected_through on spotlights, cylinders, parallel and area lights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, 0.6, 0> right x*image_width/image_height angle 50 }
#macro Glow(C) looks_like { sphere { 0, 0.15 pigment { rgb C } finish { emission 0.8 } } } #end
#macro Hole(X, Z) projected_through { disc { <X, 2, Z>, y, 0.7 } } #end
light_source { <-3, 3, -2> rgb <0.9, 0.4, 0.3> spotlight point_at <-3, 0, -2> radius 15 falloff 30 Glow(<1, 0.5, 0.4>) }
light_source { <-1, 3, -2> rgb <0.3, 0.8, 0.4> cylinder point_at <-1, 0, -2> radius 0.4 falloff 0.8 tightness 1 Glow(<0.4, 1, 0.5>) }
light_source { <1, 3, -2> rgb <0.3, 0.3, 0.3> area_light x, z, 3, 3 fade_distance 1.5 fade_power 2 Glow(<1, 1, 0.8>) }
light_source { <-2.5, 3, 2> rgb <0.9, 0.7, 0.3> spotlight point_at <-2.5, 0, 2> radius 20 falloff 35 Hole(-2.3, 2) }
light_source { <0, 3, 2> rgb <0.3, 0.5, 0.9> area_light x, z, 4, 4 Hole(0.2, 2) }
light_source { <2.5, 3, 2> rgb <0.7, 0.4, 0.8> parallel point_at <2.7, 0, 2> Hole(2.5, 2) }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-2.4, 0.4, 1.8>, 0.4 pigment { rgb <0.9, 0.8, 0.6> } }
box { <-0.3, 0, 1.7>, <0.3, 0.6, 2.2> pigment { rgb <0.6, 0.8, 0.9> } }
cylinder { <2.5, 0, 1.9>, <2.5, 0.8, 1.9>, 0.25 pigment { rgb 0.8 } }
