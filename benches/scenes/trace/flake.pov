// 7381 spheres, each with nine smaller ones around it, down to four levels; `Declare=Depth=6` makes it 597,871.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.1,1.3,1.7>*1.2 look_at 0 angle 40 }
light_source { <4,3,2>*10 rgb 0.7 } light_source { <1,-4,4>*10 rgb 0.4 }
#ifndef (Depth) #declare Depth = 4; #end
#macro Flake(C, R, D, N)
  sphere { C, R }
  #if (N > 0)
    #local A = vnormalize(vcross(D, <0.3,0.7,0.11>));
    #local B = vcross(D, A);
    #local K = 0;
    #while (K < 9)
      #if (K < 6) #local E = vnormalize(A*cos(K*pi/3) + B*sin(K*pi/3) + 0.0*D);
      #else #local E = vnormalize(A*cos((K+0.25)*2*pi/3) + B*sin((K+0.25)*2*pi/3) + 1.2*D); #end
      Flake(C + E*R*4/3, R/3, E, N-1)
      #local K = K + 1;
    #end
  #end
#end
union { Flake(<0,0,0>, 0.5, <0,0,1>, Depth) pigment { rgb <1,0.75,0.33> } finish { diffuse 0.7 reflection 0.0 specular 0.5 } }
plane { z, -0.9 pigment { rgb 0.5 } }
