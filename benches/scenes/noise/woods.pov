// Two layers of woods.inc, with the turbulence of each.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "woods.inc"
#declare Shown = texture { T_Wood7 scale 2 }
#include "stage.inc"
