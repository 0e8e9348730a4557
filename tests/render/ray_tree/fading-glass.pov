// Light fades in coloured glass by distance, by power and exponentially.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#macro Block(X, Power)
  box { <X - 0.5, -0.5, -0.4>, <X + 0.5, 0.9, 0.9>
    pigment { rgbf 1 } finish { ambient 0 diffuse 0 specular 0.4 }
    interior { ior 1.2 fade_distance 0.5 fade_power Power fade_color rgb <0.1, 0.6, 0.3> }
    rotate 10*y
  }
#end
Block(-1.4, 1) Block(0, 2) Block(1.4, 1001)
