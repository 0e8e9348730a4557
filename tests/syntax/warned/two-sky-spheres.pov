#version 3.7;
global_settings { assumed_gamma 1 }
sky_sphere { pigment { rgb 1 } }
sky_sphere { pigment { rgb 0 } }
sphere { 0, 1 }
