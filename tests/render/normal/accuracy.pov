// accuracy: how far apart the probes of patterns without a formula of their own are.
#version 3.7;
#include "grid.inc"
Bend(normal { granite 0.4 scale 0.5 })
Bend(normal { granite 0.4 accuracy 0.1 scale 0.5 })
Bend(normal { granite 0.4 accuracy 0.001 scale 0.5 })
Bend(normal { crackle 1 accuracy 0.1 scale 0.3 })
Bend(normal { checker 0.5 accuracy 0.05 scale 0.4 })
Bend(normal { brick 0.5 accuracy 0.01 scale 0.1 })
Bend(normal { gradient x 0.5 accuracy -0.05 scale 0.3 })
Bend(normal { bumps 0.8 accuracy 0.5 scale 0.2 })
Bend(normal { average normal_map { [1 granite 0.5 accuracy 0.1] [1 wood 1 accuracy 0.005 scale 0.2] } })
Bend(normal { hexagon 0.5 accuracy 0.1 rotate x*90 scale 0.3 })
Bend(normal { leopard 0.5 accuracy 0.3 scale 0.1 })
Bend(normal { agate 0.5 accuracy 0.004 scale 0.4 })
