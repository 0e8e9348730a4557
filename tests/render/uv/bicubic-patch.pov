// Texture coordinates of bicubic patches, flat, smooth and with vectors of their own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0 angle 40 }
light_source { <-20, 30, -30> rgb 1 }
background { rgb 0.2 }

#declare Squares = pigment {
  uv_mapping
  checker
    pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.9, 0.8, 0.1>] } }
    pigment { gradient y color_map { [0 rgb <0.1, 0.2, 0.8>] [1 rgb <0.2, 0.9, 0.8>] } }
  scale <1/8, 1/6, 1>
}

#macro Patch(Kind, Own)
  bicubic_patch {
    type Kind u_steps 3 v_steps 3 flatness 0
    #if (Own) uv_vectors <0.1, 0.2>, <1.5, 0>, <1, 2>, <-0.3, 1> #end
    <-1, 0, -1>, <-0.3, 0.5, -1>, <0.3, -0.5, -1>, <1, 0, -1>,
    <-1, 0.6, -0.3>, <-0.3, 1, -0.3>, <0.3, 0.4, -0.3>, <1, 0.3, -0.3>,
    <-1, -0.6, 0.3>, <-0.3, 0.2, 0.3>, <0.3, 0.6, 0.3>, <1, 0.3, 0.3>,
    <-1, 0, 1>, <-0.3, 0.5, 1>, <0.3, -0.5, 1>, <1, 0, 1>
#end
Patch(0, no) pigment { Squares } rotate -20*x translate -1.3*x }
Patch(1, no) pigment { Squares } rotate <-20, 40, 0> translate 1.3*x }
Patch(1, yes) pigment { Squares } rotate -20*x translate 2.5*z }
