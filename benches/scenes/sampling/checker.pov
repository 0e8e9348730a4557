// A checkered plane to the horizon.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -6> look_at <0, 0.7, 0> right x*image_width/image_height angle 50 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.5, 0.7, 1> }
plane { y, 0 pigment { checker rgb 1 rgb <0.1, 0.1, 0.2> } }
