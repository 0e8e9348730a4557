#version 3.7;
global_settings { assumed_gamma 1 }
#declare F = finish { phong albedo 0.5 diffuse albedo 0.7, 0.1 brilliance 2 }
sphere { 0, 1 finish { F ambient rgb <0.1, 0.2, 0.3> } }
sphere { 0, 1 finish { specular 0.8 roughness 0.01 metallic reflection { 0.1, 0.9 fresnel falloff 2 metallic 0.5 } conserve_energy } }
sphere { 0, 1 finish { reflection { 0.6 fresnel on } reflection_exponent 2 irid { 0.3 thickness 0.5 turbulence 1 } } }
sphere { 0, 1 finish { emission 1 subsurface { translucency <1, 2, 3> } crand 0.1 } }
