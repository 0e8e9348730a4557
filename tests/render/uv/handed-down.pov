// What uses `uv_mapping` hands it down to its members, their own textures included, which it goes on moving.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -5> look_at <0, 0, 0> right x*image_width/image_height angle 45 }
light_source { <5, 8, -6> rgb 1 }
#declare Stripes = texture { pigment { gradient x triangle_wave scale 0.3 } }
union { torus { 0.6, 0.2 texture { Stripes } } translate <-1.5, 0, 1> uv_mapping }
union { torus { 0.6, 0.2 texture { Stripes } } uv_mapping translate <0.1, 0, 1> }
union { union { torus { 0.6, 0.2 } texture { Stripes } } translate <1.6, 0, 1> uv_mapping texture { pigment { rgb x } } }
merge { union { torus { 0.6, 0.2 } uv_mapping } sphere { 0, 0.3 } texture { Stripes } translate <-1.5, 0, -1> }
intersection {
    sphere { 0, 0.6 texture { Stripes scale 0.5 } }
    box { -0.5, 0.5 texture { pigment { checker rgb y, rgb 1 scale 0.2 } } }
    uv_mapping
    rotate 30*y
    translate <0.1, 0, -1>
}
object { union { torus { 0.6, 0.2 uv_mapping texture { Stripes } } } translate <1.6, 0, -1> }
