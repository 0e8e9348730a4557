#version 3.7;
global_settings { assumed_gamma 1 }
#declare Angle = asin(2);
sphere { 0, 1 }
