// The amount of a normal: after the pattern, as bump_size, 0, negative, large, and renewed after a name.
#version 3.7;
#include "grid.inc"
#declare Named = normal { bumps 0.8 scale 0.15 }
Bend(normal { bumps scale 0.15 })
Bend(normal { bumps 1.5 scale 0.15 })
Bend(normal { bumps bump_size 1.5 scale 0.15 })
Bend(normal { bumps -0.8 scale 0.15 })
Bend(normal { bumps 0 scale 0.15 })
Bend(normal { Named })
Bend(normal { Named 0.2 })
Bend(normal { Named scale 3 bump_size 2 })
Bend(normal { Named dents 2 })
Bend(normal { granite 0.2 bump_size 0.6 scale 0.5 })
Bend(normal { wood -0.8 scale 0.2 })
Bend(normal { checker normal { bumps 1 scale 0.1 } normal { bumps -1 scale 0.1 } scale 0.4 bump_size 0.1 })
