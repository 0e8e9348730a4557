// Bumps in the way of rays that go everywhere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { fisheye angle 200 right x*image_width/image_height location <0, 1, -2> look_at <0, 0.2, 0> normal { bumps 0.5 } }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }
sphere { <-1, 0.2, 0>, 0.7 pigment { rgb <0.9, 0.4, 0.3> } }
box { <0.3, -0.6, -0.6>, <1.4, 0.6, 0.5> pigment { rgb <0.3, 0.5, 0.9> } }
cone { <0, -0.6, 2>, 0.7, <0, 1.6, 2>, 0 pigment { rgb <0.4, 0.8, 0.4> } }
