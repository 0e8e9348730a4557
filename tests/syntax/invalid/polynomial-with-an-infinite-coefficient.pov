#version 3.7;
global_settings { assumed_gamma 1 }
poly { 2, <1,0,0,1e300*1e300,0,0,0,1,0,-1> }
