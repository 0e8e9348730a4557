#version 3.7;
global_settings { assumed_gamma 1 }
polygon { 2, 0, x }
