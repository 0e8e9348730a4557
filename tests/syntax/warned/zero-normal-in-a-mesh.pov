#version 3.7;
global_settings { assumed_gamma 1 }
mesh { smooth_triangle { 0, 0, x, z, y, z } }
