// Named transforms, their inverses and a mirrored object.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare Move = transform { rotate <10, 40, 0> translate <1.2, 0.3, 0> scale 1.2 }
#declare Thing = union { cone { 0, 0.5, 0.9*y, 0.1 } sphere { <0.5, 0.1, 0>, 0.25 } pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.6 } }
object { Thing transform { Move } }
object { Thing transform { Move } transform { Move inverse } }
object { Thing scale <-1, 1, 1> transform { Move } translate -2.9*x }
