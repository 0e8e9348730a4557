#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 pigment { agate agate_turb 0.5 frequency 2 phase 0.1 } }
sphere { 0, 1 pigment { brick rgb 1, rgb 0 brick_size <4, 2, 1> mortar 0.2 } }
sphere { 0, 1 pigment { crackle form <1, 0, 0> metric 1 offset 0.1 solid } }
sphere { 0, 1 normal { facets size 0.3 coords 1 } }
sphere { 0, 1 pigment { function { x*y } sine_wave } }
sphere { 0, 1 pigment { gradient 2*y poly_wave 3 } }
sphere { 0, 1 pigment { hexagon rgb 1 } }
sphere { 0, 1 pigment { julia <0.3, 0.5>, 20 exponent 3 interior 1, 2 exterior 2, 3 } }
sphere { 0, 1 pigment { magnet 2 mandel 30 } }
sphere { 0, 1 pigment { object { box { 0, 1 } rgb 0, rgb 1 } } }
sphere { 0, 1 pigment { pavement number_of_sides 4 number_of_tiles 3 pattern 2 } }
sphere { 0, 1 pigment { pigment_pattern { bozo scale 2 } } }
sphere { 0, 1 pigment { quilted control0 0.5 } }
sphere { 0, 1 pigment { slope { 2*y, 0.1, 0.9 altitude y, 0, 2 } } }
sphere { 0, 1 pigment { spiral1 3 } }
sphere { 0, 1 pigment { tiling 12 } }
sphere { 0, 1 pigment { image_map { function 4, 4 { x } interpolate 2 once repeat <2, 1> filter all 0.5 } scale 2 } }
sphere { 0, 1 normal { bump_map { function 4, 4 { x } bump_size 3 } } }
sphere { 0, 1 pigment { image_pattern { function 4, 4 { x } use_alpha } } }
sphere { 0, 1 pigment { uv_mapping wood quick_color rgb 1 } }
