#version 3.7;
global_settings { assumed_gamma 1 }
#default { camera { location -5*z } finish { ambient 0.2 } normal { bump_size 1.5 } }
camera { angle 40 }
sphere { 0, 1 normal { bumps } }
#default { pigment { bozo scale 2 } }
box { -1, 1 pigment { checker } }
