// Refraction, total internal reflection and Fresnel reflection at a glass ball and a glass cube.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare Glass = material {
  texture { pigment { rgbf <0.95, 1, 0.97, 0.95> } finish { ambient 0 diffuse 0 specular 0.6 roughness 0.01 reflection { 0, 1 fresnel } conserve_energy } }
  interior { ior 1.5 }
}
sphere { <-0.9, 0.3, 0>, 0.8 material { Glass } }
box { -0.6, 0.6 rotate <20, 30, 0> translate <1.1, 0.3, 0.2> material { Glass } }
cylinder { <-2.5, 0, 3>, <2.5, 1.2, 3>, 0.3 pigment { rgb <0.2, 0.5, 0.9> } }
