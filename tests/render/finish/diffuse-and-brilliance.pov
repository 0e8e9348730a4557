// Ambient, emission, diffuse from both sides, brilliance.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }

#macro Ball(X, Y, F) sphere { <X, Y, 0>, 0.55 pigment { rgb <0.9, 0.6, 0.3> } finish { F } } #end
#declare F1 = finish { ambient 0.3 } #declare F2 = finish { ambient 0 diffuse 1 brilliance 3 } #declare F3 = finish { emission 0.4 diffuse 0.3 }
#declare F4 = finish { diffuse albedo 0.8 brilliance 2 } #declare F5 = finish { ambient rgb <0.3, 0, 0.3> }
Ball(-1.5, 1.1, F1) Ball(0, 1.1, F2) Ball(1.5, 1.1, F3) Ball(-1.5, -0.2, F4) Ball(0, -0.2, F5)
disc { <1.5, -0.2, 0>, <0.3, 0.3, 1>, 0.5 pigment { rgb 1 } finish { diffuse 0.6, 0.4 } }
