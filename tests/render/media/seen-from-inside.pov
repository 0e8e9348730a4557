// The camera and a lamp inside of a cloud that has a wall around it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -1.5> look_at <0, 0.2, 1> right x*image_width/image_height angle 70 }
light_source { <0.6, 0.9, 0.4> rgb <1, 0.8, 0.6> fade_distance 1 fade_power 2 }
sphere { 0, 9 inverse hollow pigment { checker rgb 0.7 rgb 0.4 } }
sphere { 0, 4 hollow pigment { rgbt 1 } interior { media { scattering { 4, <0.05, 0.07, 0.1> } absorption 0.03 intervals 2 } } }
box { <-1.2, -0.6, 0.4>, <-0.5, 0.2, 1.2> pigment { rgb <0.4, 0.7, 0.9> } }
sphere { <0.9, -0.1, 1>, 0.4 pigment { rgb <0.9, 0.5, 0.4> } }
