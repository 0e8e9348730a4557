// One box with a thousand spheres cut out of its top.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,3,-5> look_at 0 angle 40 }
light_source { <10,20,-10> rgb 1 }
#declare S = seed(1);
difference { box { <-2,-0.5,-2>, <2,0.5,2> }
 #for (I,1,1000) sphere { <rand(S)*4-2, 0.5, rand(S)*4-2>, 0.03+0.05*rand(S) } #end
 pigment { rgb <0.8,0.6,0.4> } }
