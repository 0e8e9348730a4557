// bump_map: heights from an image, sizes, interpolation, mapping, once, and transforms.
#version 3.7;
#include "grid.inc"
Bend(normal { bump_map { ppm "probe.ppm" } })
Bend(normal { bump_map { ppm "probe.ppm" bump_size 3 } })
Bend(normal { bump_map { ppm "probe.ppm" interpolate 2 } bump_size 2 })
Bend(normal { bump_map { ppm "probe.ppm" interpolate 4 bump_size 2 } scale 0.5 })
Bend(normal { bump_map { ppm "probe.ppm" once bump_size 2 } translate -0.5 })
Bend(normal { bump_map { ppm "probe.ppm" map_type 1 bump_size 2 } })
Bend(normal { bump_map { ppm "probe.ppm" map_type 2 bump_size 2 interpolate 2 } })
Bend(normal { bump_map { ppm "probe.ppm" bump_size 2 } scale <0.3, 0.6, 1> rotate z*30 })
Bend(normal { bump_map { ppm "probe.ppm" bump_size 2 } turbulence 0.3 })
Bend(normal { gradient x normal_map { [0 bump_map { ppm "probe.ppm" bump_size 2 } scale 0.3] [1 bumps 1 scale 0.1] } })
Bend(normal { bump_map { function 8, 8 { pattern { bozo scale 0.3 } } bump_size 3 } })
Bend(normal { bump_map { ppm "probe.ppm" bump_size -2 } scale 0.5 no_bump_scale })
