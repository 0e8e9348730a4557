// A smooth mesh of 3200 triangles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <5, 8, -6> rgb 1 }

background { rgb <0.05, 0.08, 0.15> }
#declare N = 40;
#macro Place(U, V)
  #local A = 2*pi*U/N; #local B = 2*pi*V/N; #local R = 0.45 + 0.1*sin(3*A + 2*B);
  <(1.4 + R*cos(B))*cos(A), R*sin(B), (1.4 + R*cos(B))*sin(A)>
#end
mesh {
  #for (U, 0, N - 1) #for (V, 0, N - 1)
    #local P = Place(U, V); #local Q = Place(U + 1, V); #local R = Place(U, V + 1); #local S = Place(U + 1, V + 1);
    triangle { P, Q, S } triangle { P, S, R }
  #end #end
  rotate -30*x translate 0.8*y
  pigment { rgb <0.5, 0.8, 0.9> }
  finish { specular 0.5 }
}
