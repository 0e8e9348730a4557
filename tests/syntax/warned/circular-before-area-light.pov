#version 3.7;
global_settings { assumed_gamma 1 }
light_source { 10, 1 circular area_light x, y, 3, 3 }
sphere { 0, 1 }
