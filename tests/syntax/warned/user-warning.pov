#version 3.7;
global_settings { assumed_gamma 1 }
#warning "the sky is missing"
sphere { 0, 1 }
