#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 3, -10> direction z look_at <-2, 2, 0> }
plane { y, 0 pigment { rgb 1 } }
plane { z, 0 pigment { rgb <0.14, 0.42, 0.56> } }
#declare Ring = torus { 2, 0.2 rotate <100, 10, 0> scale 0.4 translate <-1, 3, -6.6> }
object { Ring pigment { rgb <0.6, 0.8, 0.2> } }
light_source { <0, 4, -10>, 2 projected_through { Ring } }
light_source { <0, 3, -9>, 1 shadowless }
