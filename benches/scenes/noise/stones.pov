// Two layers of stones.inc: granite and agate under veins that let light through.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "stones.inc"
#declare Shown = texture { T_Stone8 scale 1.5 }
#include "stage.inc"
