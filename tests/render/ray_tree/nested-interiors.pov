// A bubble in glass in water: which index the ray leaves and enters.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 specular 0.5 } }
sphere { <0, 0.5, 0>, 1.3 texture { Clear } interior { ior 1.33 } }
sphere { <0, 0.5, 0>, 0.9 texture { Clear } interior { ior 1.6 } }
sphere { <0.3, 0.5, 0>, 0.45 texture { Clear } interior { ior 1.0 } }
