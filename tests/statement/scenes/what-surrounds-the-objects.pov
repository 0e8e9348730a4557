#version 3.7;
global_settings { assumed_gamma 1 }
background { rgbt <0.1, 0.2, 0.3, 0.5> }
fog { fog_type 2 distance 10 rgbft <0.5, 0.6, 0.7, 0.1, 0.2> fog_alt 2 fog_offset 1 turbulence 0.3 turb_depth 0.2 rotate z*90 }
rainbow { direction z angle 42 width 5 arc_angle 100 color_map { [0 rgb 1] [1 rgbt 1] } }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <0, 0, 1>] } } pigment { rgbt 1 } emission 0.5 rotate x*90 }
sphere { 0, 1 }
