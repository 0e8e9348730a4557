// Turbulence in a formula, and bumps from four probes of granite.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Shown = texture { pigment { marble turbulence 0.9 color_map { [0 rgb <0.2, 0.1, 0.1>] [0.3 rgb <0.8, 0.6, 0.4>] [0.6 rgb <0.3, 0.4, 0.5>] [1 rgb <0.9, 0.9, 0.8>] } scale 0.8 } normal { granite 0.3 scale 0.5 } }
#include "stage.inc"
