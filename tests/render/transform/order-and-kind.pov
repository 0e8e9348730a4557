// Transforms act in the order written; scale, shear and turn.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

box { -0.4, 0.4 rotate 30*z translate <-1.8, 0.3, 0> pigment { rgb <0.9, 0.3, 0.3> } }
box { -0.4, 0.4 translate <-0.6, 0.3, 0> rotate 20*y pigment { rgb <0.3, 0.9, 0.3> } }
sphere { 0, 0.5 scale <1, 0.5, 1.4> rotate <20, 30, 40> translate <0.7, 0.4, 0> pigment { rgb <0.3, 0.3, 0.9> } finish { specular 0.6 } }
torus { 0.4, 0.12 matrix <1, 0.4, 0, 0, 1, 0, 0.3, 0, 1, 1.8, 0.3, 0> pigment { rgb <0.9, 0.8, 0.3> } }
