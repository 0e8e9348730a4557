#version 3.7;
global_settings { assumed_gamma 1 }
fog { 10 rgb 1 }
sphere { 0, 1 }
