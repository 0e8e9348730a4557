// Twenty rings.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at 0 angle 42 }
light_source { <10, 20, -10> rgb 1 }
#declare R = seed(3);
#for (I, 1, 20)
  torus { 0.35, 0.1 rotate 360*<rand(R), rand(R), rand(R)> translate 3*<rand(R)-0.5, rand(R)-0.5, rand(R)-0.5>
          pigment { rgb <rand(R), 0.5, 0.6> } }
#end
