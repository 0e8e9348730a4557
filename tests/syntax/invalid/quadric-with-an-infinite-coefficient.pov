#version 3.7;
global_settings { assumed_gamma 1 }
quadric { <1,1,1>, <0,0,0>, <0,0,0>, -1e300*1e300 }
