#version 3.7;
global_settings { assumed_gamma 1 }
#declare Direction = vnormalize(<0, 0, 0>);
sphere { 0, 1 }
