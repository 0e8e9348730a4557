// Ellipsoid, hyperboloid, paraboloid, saddle, clipped to a box.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare Clip = box { -0.6, 0.6 }
intersection { quadric { <2, 4, 3>, <0.5, 0, 0>, <0, 0, 0>, -1 } object { Clip } pigment { rgb <0.9, 0.4, 0.3> } translate <-1.8, 0.3, 0> }
intersection { quadric { <4, -2, 4>, 0, 0, -0.4 } object { Clip } pigment { rgb <0.9, 0.8, 0.3> } translate <-0.6, 0.3, 0> }
quadric { <2, 0, 2>, 0, <0, -1, 0>, 0 translate 0.1*y clipped_by { object { Clip } } pigment { rgb <0.3, 0.8, 0.4> } translate <0.6, 0.3, 0> }
quadric { <1, 0, -1>, 0, <0, -1, 0>, 0 clipped_by { object { Clip } } pigment { rgb <0.3, 0.5, 0.9> } translate <1.8, 0.3, 0> }
