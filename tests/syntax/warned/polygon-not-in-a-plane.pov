#version 3.7;
global_settings { assumed_gamma 1 }
polygon { 5, 0, x, x + y, y + 0.5*z, 0 }
