// Plain, coloured, angle-dependent, Fresnel, metallic reflection and reflection_exponent.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#macro Ball(X, Y, F) sphere { <X, Y, 0>, 0.55 pigment { rgb <0.8, 0.5, 0.2> } finish { F } interior { ior 1.5 } } #end
#declare F1 = finish { diffuse 0.3 reflection 0.6 } #declare F2 = finish { diffuse 0.3 reflection { rgb <0.2, 0.4, 0.9> } } #declare F3 = finish { diffuse 0.3 reflection { 0, 1 falloff 3 } }
#declare F4 = finish { diffuse 0.3 reflection { 0.1, 1 fresnel } } #declare F5 = finish { diffuse 0.3 reflection { 0.7 metallic } } #declare F6 = finish { diffuse 0.3 reflection { 0.8 exponent 0.6 } }
Ball(-1.5, 1.3, F1) Ball(0, 1.3, F2) Ball(1.5, 1.3, F3) Ball(-1.5, 0, F4) Ball(0, 0, F5) Ball(1.5, 0, F6)
