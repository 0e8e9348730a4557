#version 3.7;
global_settings { assumed_gamma 1 }
#declare P = pigment { bozo turbulence 0.5 scale 3 color_map { [0 rgb 0] [1 rgb 1] } }
#declare T = texture { pigment { P } finish { phong 1 } }
// The new pattern keeps warps, turbulence and map.
sphere { 0, 1 texture { T pigment { marble } rotate x*90 } }
sphere { 0, 1 texture { T finish { phong_size 80 } } }
// What was declared has not changed.
sphere { 0, 1 texture { T } }
