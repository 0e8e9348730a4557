#version 3.1;
global_settings { assumed_gamma 2.2 }
#declare Radius = 1
sphere { 0, Radius }
