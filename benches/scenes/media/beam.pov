// Dust in a room, lit by a window's beam and a lamp behind bars.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,1.5,-6> look_at <0,1.5,0> angle 50 }
light_source { <6,7,2> rgb 1.5 spotlight point_at <0,0.5,1> radius 12 falloff 18 }
light_source { <-1,2.5,4> rgb 0.5 }
plane { y, 0 pigment { rgb 0.7 } } plane { -z, -5 pigment { rgb <0.6,0.6,0.7> } }
#for (I,0,6) cylinder { <-2+0.3*I,0,2.5>, <-2+0.3*I,4,2.5>, 0.05 pigment { rgb 0.2 } } #end
sphere { <1,0.8,1>, 0.8 pigment { rgb <0.9,0.5,0.3> } }
box { <-4,0.001,-3>, <4,5,4.9> hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.06 } intervals 4 } } }
