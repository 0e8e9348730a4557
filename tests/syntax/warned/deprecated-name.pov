#version 3.7;
global_settings { assumed_gamma 1 }
#declare deprecated once "use Radius" Size = 1;
sphere { 0, Size }
sphere { x, Size }
