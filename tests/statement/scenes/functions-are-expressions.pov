#version 3.7;
global_settings { assumed_gamma 1 }
#declare C = 2;
#declare F = function(a, b) { C*a - max(a, b, 3)/b + select(a, 1, 2) }
#declare N = function { pattern { bozo turbulence 0.1 } }
#declare T = function { transform { scale 2 } }
isosurface { function { F(x, -y) + N(x, y, z)*sum(i, 1, 3, i*x) - T(x, y, z).x } }
