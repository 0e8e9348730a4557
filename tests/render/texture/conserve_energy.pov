// conserve_energy, irid and metallic mirrors, alone and as upper layers.
#version 3.7;
#include "room.inc"
sphere { <-1.8, 0.2, 0>, 0.8 pigment { rgbt <0.9, 0.9, 1, 0.8> } finish { reflection { 0.2, 0.9 } conserve_energy specular 0.5 } interior { ior 1.3 } }
sphere { <0, 0.2, 0>, 0.8 texture { pigment { rgb <0.7, 0.4, 0.2> } finish { reflection { 0.3 metallic } conserve_energy } } texture { pigment { rgbft <1, 0.8, 0.6, 0.4, 0.3> } finish { reflection 0.4 conserve_energy } } }
sphere { <1.8, 0.2, 0>, 0.8 pigment { rgb 0.3 } normal { bumps 0.3 scale 0.3 } finish { irid { 0.5 thickness 0.4 turbulence 0.3 } reflection 0.3 specular 0.5 } }
box { <-2.5, -0.6, 1.5>, <2.5, 2.2, 1.6> texture { pigment { rgb 0.5 } finish { irid { 0.3 thickness 0.8 } } } texture { pigment { rgbt <0.8, 0.9, 1, 0.7> } finish { irid { 0.4 } } } }
