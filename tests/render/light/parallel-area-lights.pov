// Grids of lamps that are parallel, cones, beams, circular without being turned, turned without being circular.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0.2, 0> right x*image_width/image_height angle 50 }
light_source { <-4, 5, -2> rgb <0.4, 0.2, 0.2> area_light 2*x, 2*z, 4, 4 parallel point_at <-0.5, 0, 0> }
light_source { <4, 5, -2> rgb <0.2, 0.2, 0.5> area_light 2*x, 2*z, 5, 5 circular }
light_source { <0, 6, 3> rgb <0.2, 0.4, 0.2> area_light 2*x, 3*z, 3, 5 orient }
light_source { <-1, 5, 1> rgb <0.6, 0.5, 0.2> spotlight point_at <-1, 0, 1> radius 8 falloff 14 area_light x, z, 5, 5 adaptive 1 }
light_source { <2, 5, 1> rgb <0.3, 0.6, 0.6> cylinder point_at <2, 0, 1> radius 0.6 falloff 1 area_light x, z, 3, 3 }
plane { y, -0.6 pigment { rgb 0.9 } }
sphere { <-1.2, 0.2, 0>, 0.6 pigment { rgb <0.9, 0.7, 0.5> } }
torus { 0.5, 0.15 rotate 70*x translate <0.2, 0, -1> pigment { rgb <0.7, 0.9, 0.6> } }
cone { <1.8, -0.6, 0.8>, 0.4, <1.8, 0.6, 0.8>, 0.1 pigment { rgb <0.5, 0.7, 0.9> } }
