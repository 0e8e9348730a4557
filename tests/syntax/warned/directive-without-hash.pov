#version 3.7;
global_settings { assumed_gamma 1 }
declare Radius = 1;
sphere { 0, Radius }
