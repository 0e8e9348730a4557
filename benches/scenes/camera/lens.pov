// Rows of balls, one of them in focus.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,2,-7> look_at <0,0.3,0> angle 40 aperture 0.5 focal_point <0,0.4,-1> blur_samples 37 }
light_source { <-6,9,-6> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8,0.8,0.9>] [1 rgb <0.2,0.4,0.8>] } } }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3,0.4,0.3> } }
#for (Z,-3,8) #for (X,-4,4)
  sphere { <X,0.4,Z>, 0.4 pigment { rgb <0.5+0.1*X, 0.6, 0.7-0.05*Z> } finish { phong 0.5 } }
#end #end
