// A flake of mirror balls on mirror balls.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <5, 8, -6> rgb 1 }

background { rgb <0.3, 0.4, 0.6> }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.3 } }
#macro Flake(P, R, Level)
  sphere { P, R }
  #if (Level > 0)
    #for (I, 0, 8)
      #local D = vrotate(vrotate(y, (I < 3 ? 35 : 105)*x), (I < 3 ? 120*I : 60*I)*y);
      Flake(P + D*R*4/3, R/3, Level - 1)
    #end
  #end
#end
union { Flake(0.7*y, 0.9, 3) pigment { rgb <0.9, 0.85, 0.8> } finish { reflection 0.4 specular 0.5 diffuse 0.5 } }
