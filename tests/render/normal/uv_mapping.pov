// uv_mapping in pigments, normals and textures, on shapes that have coordinates of their own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at 0 right x*4/3 angle 45 }
light_source { <-20, 30, -40> rgb 0.9 }
light_source { <30, -5, -30> rgb 0.3 shadowless }
background { rgb <0.15, 0.18, 0.22> }
#declare Board = pigment { uv_mapping checker rgb <0.9, 0.8, 0.5>, rgb <0.3, 0.2, 0.4> scale 0.1 }
#declare Dents = normal { uv_mapping gradient x 1 triangle_wave scale 0.1 }
sphere { <-2.6, 1.2, 0>, 1 pigment { Board } }
sphere { <0, 1.2, 0>, 1 pigment { rgb 0.8 } normal { Dents } }
sphere { <2.6, 1.2, 0>, 1 texture { uv_mapping pigment { gradient y frequency 8 } normal { bumps 0.5 scale <0.02, 0.05, 1> } } }
box { -0.8, 0.8 pigment { Board } normal { uv_mapping quilted 1 scale 0.25 } rotate <20, 30, 0> translate <-2.6, -1.2, 0> }
torus { 0.7, 0.35 uv_mapping texture { pigment { checker rgb 1, rgb <0.2, 0.4, 0.7> scale <0.1, 0.25, 1> } normal { gradient x 0.5 sine_wave scale 0.05 } } rotate -x*50 translate <0, -1.2, 0> }
cylinder { -y, y, 0.7 texture { uv_mapping gradient x texture_map { [0 pigment { rgb <0.8, 0.3, 0.2> }] [1 pigment { Board }] } } rotate <20, 0, 20> translate <2.6, -1.2, 0> }
