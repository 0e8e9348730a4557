// Phong and specular, sizes, metallic, albedo.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }

#macro Ball(X, Y, F) sphere { <X, Y, 0>, 0.55 pigment { rgb <0.7, 0.3, 0.2> } finish { F } } #end
#declare F1 = finish { phong 1 } #declare F2 = finish { phong 0.8 phong_size 120 metallic } #declare F3 = finish { specular 1 }
#declare F4 = finish { specular 0.9 roughness 0.005 metallic 0.7 } #declare F5 = finish { specular albedo 0.3 roughness 0.1 } #declare F6 = finish { phong albedo 0.2 phong_size 20 specular 0.2 }
Ball(-1.5, 1.1, F1) Ball(0, 1.1, F2) Ball(1.5, 1.1, F3) Ball(-1.5, -0.2, F4) Ball(0, -0.2, F5) Ball(1.5, -0.2, F6)
