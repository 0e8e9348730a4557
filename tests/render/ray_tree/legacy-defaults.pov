// No #version and no assumed_gamma, as most scenes that people keep.
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { color red 0.3 green 0.4 blue 0.6 }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

sphere { <-0.8, 0.2, 0>, 0.8 pigment { color red 1 green 0.5 blue 0.2 filter 0.4 } finish { ambient 0.2 diffuse 0.7 phong 1 } }
box { <0.3, -0.6, -0.5>, <1.5, 0.8, 0.7> texture { pigment { color rgb <0.2, 0.6, 0.4> } finish { reflection 0.3 specular 0.5 } } }
