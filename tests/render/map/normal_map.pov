// normal_map and lists of normals: blended, nested, turned, scaled, and with a default for what is missing.
#version 3.7;
#include "grid.inc"
Bend(normal { gradient x normal_map { [0.3 bumps 1 scale 0.1] [0.7 gradient y 1 triangle_wave scale 0.2] } })
Bend(normal { gradient x turbulence 0.4 normal_map { [0.3 bumps 1 scale 0.1] [0.7 dents 3 scale 0.2] } scale <1, 0.4, 1> rotate z*30 })
Bend(normal { bozo normal_map { [0.4 ripples 1 frequency 4] [0.6 waves 0.3 frequency 4] } scale 0.4 })
Bend(normal { radial rotate x*90 normal_map { [0 quilted 1 scale 0.3] [1 wrinkles 1 scale 0.2] } })
Bend(normal { gradient x normal_map { [0 gradient y normal_map { [0 bumps 2 scale 0.1] [1 dents 3 scale 0.1] }] [1 crackle 1 scale 0.3] } })
Bend(normal { checker normal { gradient x 2 triangle_wave scale 0.1 } normal { gradient y 2 triangle_wave scale 0.1 } scale 0.4 })
Bend(normal { brick normal { bumps 0.5 scale 0.05 } normal { dents 1 scale 0.1 } scale 0.08 })
Bend(normal { hexagon normal { bumps 1 scale 0.1 } normal { granite 0.3 } normal { facets coords 1 size 0.1 } rotate x*90 scale 0.3 })
Bend(normal { square normal { bumps 1 scale 0.1 } normal { granite 0.3 } normal { wood 1 scale 0.1 } normal { bozo 0 } rotate x*90 scale 0.4 })
Bend(normal { object { sphere { 0, 0.5 } normal { bumps 1 scale 0.1 } normal { wood 1 scale 0.1 } } })
Bend(normal { cubic normal { bumps 1 scale 0.1 } normal { granite 0.3 } normal { wood 1 scale 0.1 } normal { bozo 0 } normal { dents 1 } normal { ripples 1 } rotate 30 })
Bend(normal { gradient x normal_map { [0 bumps 1 scale 0.1 no_bump_scale] [1 bumps 1 scale 0.1] } scale <1, 3, 1> })
