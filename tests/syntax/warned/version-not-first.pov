global_settings { assumed_gamma 1 }
#version 3.7;
sphere { 0, 1 }
