#version 3.7;
global_settings { assumed_gamma 1 }
#default { pigment { rgb <1, 0, 1> } }
union { sphere { 0, 1 pigment { rgb 0 } } sphere { x, 1 } }
union { sphere { 0, 1 } sphere { x, 1 } pigment { rgb 0.5 } }
difference { box { -1, 1 pigment { rgb 1 } } sphere { 0, 1.2 } cutaway_textures }
light_source { 5 rgb 1 looks_like { sphere { 0, 0.1 } } }
