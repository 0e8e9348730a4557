#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 1 look_at 1 }
