#version 3.7;
global_settings { assumed_gamma 1 }
ovus { 1, 2 }
