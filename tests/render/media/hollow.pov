// Solid glass displaces media and fog; hollow glass does not. The ground is hollow, the camera is outside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -6> look_at <0, 0.2, 0> right x*image_width/image_height angle 44 }
light_source { <-5, 8, -6> rgb 1 }
background { rgb <0.4, 0.5, 0.7> }
plane { y, -1 hollow pigment { checker rgb 0.9 rgb 0.5 } }
#declare Glass = texture { pigment { rgbt <0.9, 1, 0.95, 0.85> } finish { diffuse 0.2 specular 0.5 } }
box { <-2.8, -0.9, -1>, <2.8, 1.4, 1.5> hollow pigment { rgbt 1 } interior { media { emission <0.05, 0.1, 0.15> absorption 0.2 } } }
sphere { <-1.4, 0, 0>, 0.8 texture { Glass } interior { ior 1.3 } }
sphere { <1.4, 0, 0>, 0.8 hollow texture { Glass } interior { ior 1.3 } }
difference { sphere { 0, 0.5 } box { <0, 0, -1>, 1 } hollow texture { Glass } interior { media { emission <0.8, 0.2, 0> } } }
fog { distance 30 rgb 0.7 }
