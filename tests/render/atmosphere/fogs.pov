// Constant fog, ground fog and coloured fog together; the ground does not hold them off.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -8> look_at <0, 0.8, 0> right x*image_width/image_height angle 50 }
light_source { <-8, 12, -6> rgb 1 }
background { rgb <0.3, 0.45, 0.75> }
plane { y, -1 hollow pigment { checker rgb 0.9 rgb <0.3, 0.5, 0.3> scale 2 } }
#for (I, 0, 7) cylinder { <I*1.5 - 5, -1, I*4>, <I*1.5 - 5, 4, I*4>, 0.5 pigment { rgb <0.8, 0.4, 0.3> } } #end
fog { distance 60 rgbt <0.7, 0.75, 0.85, 0.2> }
fog { fog_type 2 distance 8 fog_offset 0 fog_alt 0.7 rgb <0.9, 0.9, 0.8> up <0.2, 1, 0> }
fog { distance 120 rgbf <0.9, 0.5, 0.4, 0.4> }
