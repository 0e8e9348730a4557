// Layers with filter, transmit and both, over and under patterns; each with bumps and a finish of its own.
#version 3.7;
#include "room.inc"
#declare Ground = texture { pigment { gradient x color_map { [0.5 rgb <0.9, 0.8, 0.2>] [0.5 rgb <0.2, 0.3, 0.7>] } scale 0.4 } }
sphere { <-1.8, 0.2, 0>, 0.8 texture { Ground } texture { pigment { rgbf <1, 0.5, 0.5, 0.8> } } }
sphere { <0, 0.2, 0>, 0.8 texture { Ground } texture { pigment { rgbt <1, 0.5, 0.5, 0.6> } normal { bumps 1 scale 0.1 } finish { phong 0.8 } } }
sphere { <1.8, 0.2, 0>, 0.8 texture { Ground normal { bumps 0.6 scale 0.2 } } texture { pigment { rgbft <0.4, 0.9, 0.5, 0.5, 0.3> } finish { ambient 0.3 reflection 0.2 } } }
box { <-2.5, -0.6, 1.2>, <-0.2, 2.2, 1.6>
  texture { pigment { rgbt <0.9, 0.9, 1, 0.7> } }
  texture { pigment { bozo color_map { [0.4 rgbt 1] [0.6 rgbf <0.9, 0.3, 0.1, 0.6>] } scale 0.4 } }
}
box { <0.2, -0.6, 1.2>, <2.5, 2.2, 1.6>
  texture { Ground }
  texture { pigment { wood color_map { [0 rgbt 1] [1 rgbft <0.6, 0.9, 0.6, 0.3, 0.5>] } scale 0.5 } }
  texture { pigment { crackle color_map { [0 rgb 0] [0.1 rgbt 1] } scale 0.5 } }
}
