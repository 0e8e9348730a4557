#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 clipped_by { plane { y, 0 pigment { rgb 1 } } } }
