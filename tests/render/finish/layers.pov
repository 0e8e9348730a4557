// Layers: what an upper one lets through, highlights of clear ones, conserve_energy.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

sphere { <-1.2, 0.3, 0>, 0.85
  texture { pigment { checker rgb 1 rgb <0.1, 0.2, 0.6> scale 0.3 } }
  texture { pigment { gradient y color_map { [0 rgbt 1] [1 rgbt <1, 0.3, 0.1, 0>] } } }
  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 phong 1 } }
}
sphere { <1.2, 0.3, 0>, 0.85
  texture { pigment { rgb <0.2, 0.7, 0.4> } finish { reflection 0.2 } }
  texture { pigment { rgbft <0.9, 0.6, 0.3, 0.4, 0.3> } finish { reflection { 0.5 } conserve_energy specular 0.5 } }
}
