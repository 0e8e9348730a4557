// Spheres, cylinders, cones and tori, open and closed.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

cylinder { <-1.9, -0.5, 0>, <-1.5, 0.7, 0.3>, 0.35 pigment { rgb <0.9, 0.4, 0.3> } }
cylinder { <-0.9, -0.4, -0.5>, <-0.7, 0.5, 0>, 0.3 open pigment { rgb <0.9, 0.8, 0.3> } }
cone { <0.2, -0.6, 0>, 0.5, <0.3, 0.8, 0.2>, 0.15 pigment { rgb <0.3, 0.8, 0.4> } }
cone { <1.1, 0.5, 0>, 0.4, <1.1, -0.6, 0>, 0.1 open pigment { rgb <0.3, 0.5, 0.9> } }
torus { 0.45, 0.15 rotate <60, 20, 0> translate <1.9, 0.2, 0.3> pigment { rgb <0.8, 0.3, 0.8> } }
