#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { radiosity { recursion_limit 21 } }
