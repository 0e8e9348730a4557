// Ground fog of uneven thickness, and lamps that it dims.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -8> look_at <0, 0.8, 0> right x*image_width/image_height angle 50 }
light_source { <-8, 12, -6> rgb 1 media_attenuation on }
background { rgb <0.3, 0.45, 0.75> }
plane { y, -1 hollow pigment { rgb <0.4, 0.5, 0.3> } }
#for (I, 0, 7) sphere { <I*1.5 - 5, 0, I*3>, 0.9 pigment { rgb <0.8, 0.4, 0.3> } } #end
fog { fog_type 2 distance 12 fog_offset 0 fog_alt 1 rgb 0.9 turbulence <0.6, 0.3, 0.6> turb_depth 0.8 octaves 4 omega 0.6 lambda 2.2 }
