// A plane seen from 10^6 above: POV-Ray's ground ends 10^7 away, before the horizon; and a box whose
// floor is out of reach has no shadow in a scene of 10^-4.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 1e6*y look_at <0, 8.8e5, 1e6> angle 60 }
background { rgb <0.35, 0.55, 0.9> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.6>, rgb <0.5, 0.4, 0.3> scale 1.5e6 } finish { ambient 1 diffuse 0 } }
