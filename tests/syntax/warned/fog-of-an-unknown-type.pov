#version 3.7;
global_settings { assumed_gamma 1 }
fog { distance 10 rgb 1 fog_type 3 }
sphere { 0, 1 }
