// A texture given before a transform moves with the object, one given after stays.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare Stripes = pigment { gradient x color_map { [0.5 rgb <1, 0.9, 0.6>] [0.5 rgb <0.4, 0.1, 0.1>] } scale 0.3 }
box { -0.5, 0.5 pigment { Stripes } rotate <20, 45, 30> translate <-1.3, 0.3, 0> }
box { -0.5, 0.5 rotate <20, 45, 30> translate <0.1, 0.3, 0> pigment { Stripes } }
box { -0.5, 0.5 pigment { Stripes rotate 90*z } rotate <20, 45, 30> translate <1.5, 0.3, 0> }
