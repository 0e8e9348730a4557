#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*y look_at 0 }
sphere { 0, 1 }
