// A worm of ten balls.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at 0 angle 42 }
light_source { <10, 20, -10> rgb 1 }
#declare R = seed(2);
sphere_sweep { b_spline 12
  #for (I, 1, 12) , 2.4*<rand(R)-0.5, rand(R)-0.5, rand(R)-0.5>, 0.1 + 0.2*rand(R) #end
  pigment { rgb <0.7, 0.5, 0.8> }
}
