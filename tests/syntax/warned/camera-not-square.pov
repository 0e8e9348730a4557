#version 3.7;
global_settings { assumed_gamma 1 }
camera { right x up x + y }
sphere { 0, 1 }
