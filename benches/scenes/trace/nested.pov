// A box cut by a thousand spheres, each difference inside of the next.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,3,-5> look_at 0 angle 40 }
light_source { <10,20,-10> rgb 1 }
#declare S = seed(1);
#declare Solid = box { <-2,-0.5,-2>, <2,0.5,2> };
#for (I,1,1000)
  #declare Solid = difference {
    object { Solid }
    sphere { <rand(S)*4-2, 0.5, rand(S)*4-2>, 0.03+0.05*rand(S) }
  };
#end
object { Solid pigment { rgb <0.8,0.6,0.4> } }
