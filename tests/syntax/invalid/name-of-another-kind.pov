#version 3.7;
global_settings { assumed_gamma 1 }
#declare P = pigment { rgb 1 } sphere { 0, 1 texture { finish { P } } }
