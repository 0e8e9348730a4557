#version 3.7;
global_settings { assumed_gamma 1 }
triangle { 0, x, y inverse }
