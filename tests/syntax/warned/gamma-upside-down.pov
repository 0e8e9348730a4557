#version 3.7;
global_settings { assumed_gamma 0.45 }
sphere { 0, 1 }
