#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z }
camera { location -4*z }
sphere { 0, 1 }
