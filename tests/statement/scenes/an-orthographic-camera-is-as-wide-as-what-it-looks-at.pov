#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -3*z look_at 0 }
sphere { 0, 1 }
