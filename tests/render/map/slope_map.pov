// slope_map: straight, curved, with equal positions, on waves, under turbulence and non-uniform scale.
#version 3.7;
#include "grid.inc"
Bend(normal { gradient x 0.5 slope_map { [0 <0, 1>] [1 <1, 1>] } scale 0.4 })
Bend(normal { gradient x 0.5 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.4 })
Bend(normal { gradient x 0.5 slope_map { [0 <0, 0>] [0.5 <1, 0>] [0.5 <0, 0>] [1 <1, 0>] } scale 0.4 })
Bend(normal { gradient x 0.5 slope_map { [0.3 <0, 3>] [0.7 <0, -3>] } scale 0.4 })
Bend(normal { onion 0.5 sine_wave slope_map { [0 <0, 1>] [1 <1, -1>] } scale 0.3 })
Bend(normal { bozo 0.8 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.2 })
Bend(normal { wood 0.5 turbulence 0.1 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.3 })
Bend(normal { radial 0.6 frequency 8 rotate x*90 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } })
Bend(normal { crackle 0.8 slope_map { [0 <0, 0>] [0.2 <1, 0>] [1 <1, 0>] } scale 0.3 })
Bend(normal { bumps 0.8 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.2 })
Bend(normal { gradient x 0.5 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale <0.3, 1, 2> rotate <20, 30, 40> })
Bend(normal { gradient x 0.5 slope_map { [0.6 <0, 1>] [0.2 <1, 0>] [0.8 <0.5, -1>] } accuracy 0.05 scale 0.4 })
