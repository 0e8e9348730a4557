// Ten octaves of noise as a colour, and of vector noise as bumps.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Shown = texture { pigment { wrinkles color_map { [0 rgb <0.2, 0.1, 0.1>] [0.3 rgb <0.8, 0.6, 0.4>] [0.6 rgb <0.3, 0.4, 0.5>] [1 rgb <0.9, 0.9, 0.8>] } scale 0.8 } normal { wrinkles 0.6 scale 0.5 } finish { phong 0.4 } }
#include "stage.inc"
