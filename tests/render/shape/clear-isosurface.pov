// A ray goes on behind a crossing of an isosurface that stands alone, and so does what it throws a shadow with.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0, 0> right x*image_width/image_height angle 45 }
light_source { <5, 8, -5> rgb 1 }
plane { y, -1 pigment { rgb 0.9 } }
#declare Ball = function { x*x + y*y + z*z - 0.6 }
isosurface { function { Ball(x, y, z) } max_gradient 4 pigment { rgbf <0.2, 0.8, 0.7, 0.55> } translate -2*x }
isosurface { function { max(x, y*0.7, z) - 0.6 } max_gradient 2 pigment { rgbf <0.9, 0.6, 0.2, 0.6> } interior { ior 1.2 } }
union {
    isosurface { function { Ball(x, y, z) } max_gradient 4 open contained_by { box { -1, 0.5 } } }
    box { <-0.6, -1, 0>, <0.6, 0.8, 0.1> }
    pigment { rgbt <0.4, 0.6, 0.9, 0.5> }
    translate 2*x
}
