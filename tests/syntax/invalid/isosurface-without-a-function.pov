#version 3.7;
global_settings { assumed_gamma 1 }
isosurface { contained_by { box { -1, 1 } } }
