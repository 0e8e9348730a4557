#version 3.7;
global_settings { assumed_gamma 1 }
light_source { 0 rgb 1 area_light x, y, 0, 2 }
