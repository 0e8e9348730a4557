// Solids cut out of solids.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <5, 8, -6> rgb 1 }

background { rgb 0.1 }
plane { y, 0 pigment { rgb 0.6 } }
#declare Part = difference {
  box { -0.8, 0.8 }
  cylinder { -z, z, 0.5 }
  cylinder { -x, x, 0.5 }
  cylinder { -y, y, 0.5 }
  sphere { 0.8, 0.35 }
  sphere { <-0.8, 0.8, -0.8>, 0.3 }
  pigment { rgb <0.9, 0.6, 0.2> }
  finish { specular 0.4 }
}
#for (I, -1, 1) object { Part rotate (25 + 30*I)*y translate <1.9*I, 0.85, 0.5> } #end
