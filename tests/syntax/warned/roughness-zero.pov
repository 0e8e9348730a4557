#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 finish { specular 1 roughness 0 } }
