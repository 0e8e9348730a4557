// No noise: what the stage itself costs.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Shown = texture { pigment { rgb <0.8, 0.6, 0.4> } }
#include "stage.inc"
