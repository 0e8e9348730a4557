#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 finish { reflection { 1 fresnel 2 } } }
