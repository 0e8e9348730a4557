#version 3.7;
global_settings { assumed_gamma 1 }
polygon { 4, 0, x, 2*x, 0 }
