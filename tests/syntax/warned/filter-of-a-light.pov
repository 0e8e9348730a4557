#version 3.7;
global_settings { assumed_gamma 1 }
light_source { 10, rgbf 1 }
sphere { 0, 1 }
