// A difference of differences, twelve cutters, turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

difference {
  box { -0.9, 0.9 }
  union {
    #for (I, 0, 2)
      #for (J, 0, 2)
        cylinder { <0.5*(I - 1), 0.5*(J - 1), -2>, <0.5*(I - 1), 0.5*(J - 1), 2>, 0.17 }
      #end
    #end
  }
  difference { sphere { 0, 1.15 inverse } box { -2, 2 inverse } }
  sphere { <0.9, 0.9, -0.9>, 0.5 }
  pigment { rgb <0.85, 0.75, 0.4> }
  finish { specular 0.4 }
  rotate <15, 30, 0>
  translate 0.5*y
}
