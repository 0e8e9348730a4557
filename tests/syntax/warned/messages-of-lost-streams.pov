#version 3.7;
global_settings { assumed_gamma 1 }
#statistics "spheres: 1\n"
sphere { 0, 1 }
