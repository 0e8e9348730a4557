// crand: grain in diffuse light. POV-Ray draws it in the order its threads trace, povista by place,
// so that no two pictures of POV-Ray's agree in the grain itself.
#version 3.7;
#include "room.inc"
sphere { <-1.3, 0.3, 0>, 0.9 pigment { rgb <0.8, 0.6, 0.3> } finish { diffuse 0.7 crand 0.15 } }
sphere { <1.3, 0.3, 0>, 0.9 texture { pigment { rgb <0.3, 0.6, 0.8> } } texture { pigment { rgbt <1, 1, 1, 0.5> } finish { crand 0.3 } } }
