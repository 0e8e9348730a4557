#version 3.7;
global_settings { assumed_gamma 1 }
#declare T = texture { pigment { rgb 1 } } texture { pigment { rgbt <1, 0, 0, 0.5> } }
sphere { 0, 1 texture { T } texture { pigment { rgbf <0, 1, 0, 0.7> } scale 2 } }
// A transform reaches the layers before it.
sphere { 0, 1 texture { pigment { checker } } translate x texture { pigment { hexagon rgbt 1 } } }
