#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, -1 }
torus { 1, -0.2 }
cylinder { 0, y, 2 - 3 }
disc { 0, y, -0.5 }
