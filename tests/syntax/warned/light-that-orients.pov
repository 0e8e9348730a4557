#version 3.7;
global_settings { assumed_gamma 1 }
light_source { 10, 1 area_light x, y, 3, 3 orient }
sphere { 0, 1 }
