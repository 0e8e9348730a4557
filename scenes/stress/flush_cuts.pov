// Cutters and merged parts that end exactly where what they cut ends: a hole closed by its own cap,
// speckled faces, a face that is gone.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -8> direction z right 8*x up 6*y }
light_source { <-5, 8, -12> rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Red = pigment { rgb <0.9, 0.25, 0.2> };
#declare Green = pigment { rgb <0.3, 0.8, 0.35> };
difference {
  box { -1, 1 pigment { Red } }
  box { <-0.5, -0.5, -1>, <0.5, 0.5, 0.5> pigment { Green } }
  rotate <10, 20, 30> translate <-2.1, 1.4, 0>
}
difference {
  box { -1, 1 pigment { Red } }
  cylinder { -z, z, 0.5 pigment { Green } }
  translate <2.1, 1.4, 0>
}
merge {
  box { <-1, -1, -1>, <0.5, 1, 1> pigment { Red } }
  box { <-0.5, -1, -1>, <1, 1, 1> pigment { Red } }
  translate <-2.1, -1.5, 0>
}
intersection {
  cylinder { -z, z, 1 pigment { Red } }
  cylinder { -z, z, 1 pigment { Green } }
  rotate <20, 30, 0> translate <2.1, -1.5, 0>
}
