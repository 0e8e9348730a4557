// Two hundred fields in one blob.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at 0 angle 42 }
light_source { <10, 20, -10> rgb 1 }
#declare R = seed(5);
blob { threshold 0.5
  #for (I, 1, 200)
    sphere { 2.4*<rand(R)-0.5, rand(R)-0.5, rand(R)-0.5>, 0.3 + 0.1*rand(R), 1 }
  #end
  pigment { rgb <0.4, 0.8, 0.5> }
}
