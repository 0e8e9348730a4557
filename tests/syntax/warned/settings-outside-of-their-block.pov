#version 3.7;
global_settings { assumed_gamma 1 }
max_trace_level 10
sphere { 0, 1 }
