#version 3.7;
global_settings { assumed_gamma 1 }
#declare One = function (x) { pow(x, 0) };
sphere { 0, 1 }
