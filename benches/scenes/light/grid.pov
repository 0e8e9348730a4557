// Sixty mirrors under an area light of 17 by 17 places, each of which every point asks.
#version 3.7; global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <0,3,-8> look_at 0 angle 40 }
light_source { <10,20,-10> rgb 1 area_light x*4, z*4, 17, 17 }
plane { y, -1.5 pigment { checker rgb 1 rgb 0.2 } }
#declare S = seed(3);
#for (I,1,60) sphere { <rand(S)*4-2, rand(S)*3-1, rand(S)*4-2>, 0.25 pigment { rgb <0.9,0.95,1> } finish { reflection 0.4 specular 0.4 } } #end
