#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { max_trace_level 300 number_of_waves 0 hf_gray_16 on max_intersections 64 }
sphere { 0, 1 }
