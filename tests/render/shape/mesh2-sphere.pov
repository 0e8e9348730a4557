// A mesh2 with normals, uv and an inside_vector, made by loops.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare N = 12;
#macro P(I, J) vrotate(x, <0, 360*I/N, 0>)*sin(pi*J/N) + y*cos(pi*J/N) #end
#declare Ball = mesh2 {
  vertex_vectors { (N + 1)*(N + 1) #for (J, 0, N) #for (I, 0, N) , P(I, J) #end #end }
  normal_vectors { (N + 1)*(N + 1) #for (J, 0, N) #for (I, 0, N) , P(I, J) #end #end }
  face_indices { 2*N*(N - 1)
    #for (J, 0, N - 1) #for (I, 0, N - 1)
      #local A = J*(N + 1) + I; #local C = A + N + 1;
      #if (J > 0) , <A, A + 1, C> #end
      #if (J < N - 1) , <A + 1, C + 1, C> #end
    #end #end
  }
  inside_vector y
}
object { Ball scale 0.8 translate <-1.1, 0.3, 0> pigment { rgb <0.9, 0.5, 0.3> } finish { phong 0.7 } }
difference { object { Ball scale 0.8 } box { <0, -1, -1>, <1, 1, 0> } translate <1.1, 0.3, 0> pigment { rgb <0.4, 0.6, 0.9> } }
