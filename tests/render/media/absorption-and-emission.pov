// Plain media that swallow and give off light, in bodies of several shapes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 0.3, 0> right x*image_width/image_height angle 45 }
light_source { <-5, 8, -6> rgb 1 }
plane { y, -1 hollow pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.6> } }

#declare Clear = texture { pigment { rgbt 1 } }
sphere { <-1.6, 0, 0>, 0.9 hollow texture { Clear } interior { media { absorption <0.2, 0.8, 1.4> } } }
box { <-0.5, -0.8, -0.6>, <0.6, 0.9, 0.7> hollow texture { Clear }
  interior { media { emission <0.5, 0.25, 0.1> absorption 0.3 } } }
torus { 0.6, 0.3 hollow texture { Clear } rotate 60*x translate <1.7, 0, 0>
  interior { media { emission <0, 0.4, 0.9> } } }
