#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 hollow interior { media { scattering { 9, 1 } } } }
