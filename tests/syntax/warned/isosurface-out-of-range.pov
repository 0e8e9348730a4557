#version 3.7;
global_settings { assumed_gamma 1 }
isosurface { function { x } accuracy -1 max_gradient -1 max_trace 100 }
