#version 3.7;
global_settings { assumed_gamma 1 }
light_source { y, 1 area_light x, z, 1000000, 1000000 }
