#version 3.7;
global_settings { assumed_gamma 1 }
intersection { sphere { 0, 1 } triangle { 0, x, y } }
