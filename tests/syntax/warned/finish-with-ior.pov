#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 finish { ior 1.5 refraction 1 caustics 1 } }
