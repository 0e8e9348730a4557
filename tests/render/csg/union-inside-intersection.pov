// A union inside an intersection keeps its inner faces; a merge does not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare Glass = texture { pigment { rgbt <0.8, 0.9, 1, 0.7> } finish { specular 0.6 } }
#macro Pair(Op)
  intersection {
    #if (Op) union { #else merge { #end
      sphere { <-0.3, 0, 0>, 0.7 }
      sphere { <0.3, 0, 0>, 0.7 }
    }
    box { <-2, -0.35, -2>, <2, 0.45, 2> }
    texture { Glass }
  }
#end
object { Pair(1) translate <-1.2, 0.2, 0> }
object { Pair(0) translate <1.2, 0.2, 0> }
