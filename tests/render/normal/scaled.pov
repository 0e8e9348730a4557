// Normals under non-uniform scale, rotation and shear, of the normal, the texture and the object.
#version 3.7;
#include "grid.inc"
Bend(normal { bumps 0.8 scale <0.1, 0.4, 0.2> })
Bend(normal { granite 0.4 scale <0.3, 1, 0.5> rotate z*30 })
Bend(normal { ripples 0.8 frequency 5 scale <0.5, 0.2, 1> })
Bend(normal { quilted 1 scale <0.2, 0.6, 0.4> rotate <20, 30, 40> })
Bend(normal { facets coords 0.7 size 0.2 scale <0.5, 2, 1> })
Bend(normal { gradient x 0.5 triangle_wave matrix <0.2, 0, 0, 0.15, 0.3, 0, 0, 0, 1, 0, 0, 0> })
Cell(texture { pigment { rgb 0.8 } normal { dents 2 scale 0.2 } scale <1, 3, 0.5> })
Cell(texture { pigment { rgb 0.8 } normal { wood 0.7 scale 0.2 } rotate x*40 scale <2, 0.7, 1> })
Cell(texture { gradient x texture_map { [0 pigment { rgb 0.8 } normal { bumps 1 scale 0.1 }] [1 pigment { rgb <0.8, 0.4, 0.2> } normal { granite 0.5 }] } scale <0.4, 1.5, 1> })
Bend(normal { average normal_map { [1 bumps 1 scale <0.1, 0.5, 0.1>] [1 waves 0.2 frequency 4] } scale <0.5, 1, 1> rotate z*45 })
Bend(normal { wrinkles 0.6 turbulence 0.4 scale <0.5, 0.1, 0.3> })
Bend(normal { cells 0.4 scale <0.2, 0.3, 0.5> rotate <10, 20, 30> })
