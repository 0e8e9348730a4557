#version 3.7;
global_settings { assumed_gamma 1 }
text { ttf "nope.ttf" "a" 1, 0 }
