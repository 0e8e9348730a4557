// Unbounded children: an intersection of half-spaces.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

intersection {
  #for (I, 0, 6)
    plane { vrotate(x, <0, 360/7*I, 25>), 0.7 }
  #end
  plane { y, 1.4 } plane { -y, 0.6 }
  pigment { rgb <0.5, 0.3, 0.8> }
  finish { specular 0.7 roughness 0.02 reflection 0.15 }
  translate <0, 0.2, 0>
}
