#version 3.7;
global_settings { assumed_gamma 1 }
#declare M = color_map { [0 rgb 0] [0.5 rgbt 1] [0.5 rgbt 1] [1 color red 1] }
sphere { 0, 1 pigment { bozo color_map { M } } }
sphere { 0, 1 pigment { wood color_map { [0, 0.4 color rgb 1 color rgb 0.5] } } }
sphere { 0, 1 pigment { average pigment_map { [bozo] [2 checker] } } }
sphere { 0, 1 normal { gradient x slope_map { [0 <0, 1>] [1 <1, -1>] } } }
sphere { 0, 1 normal { gradient x normal_map { [0 bumps 0.2] [1 dents scale 0.1] } no_bump_scale } }
sphere { 0, 1 texture { gradient y texture_map { [0 pigment { rgb 1 }] [1 finish { phong 1 }] } scale 2 } }
sphere { 0, 1 texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } } }
