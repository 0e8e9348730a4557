#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { assumed_gamma 2.2 }
sphere { 0, 1 }
