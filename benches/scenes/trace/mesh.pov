// A hilly sheet of 100352 triangles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -3> look_at 0 angle 45 }
light_source { <10, 20, -10> rgb 1 }
#declare N = 224;
#declare Height = function(x, z) { 0.2*sin(5*x)*cos(7*z) + 0.05*sin(31*x + 17*z) };
mesh2 {
  vertex_vectors { (N + 1)*(N + 1)
    #for (I, 0, N) #for (J, 0, N)
      #local X = 3*I/N - 1.5; #local Z = 3*J/N - 1.5;
      , <X, Height(X, Z), Z>
    #end #end
  }
  face_indices { 2*N*N
    #for (I, 0, N - 1) #for (J, 0, N - 1)
      #local A = I*(N + 1) + J;
      , <A, A + 1, A + N + 1>, <A + 1, A + N + 2, A + N + 1>
    #end #end
  }
  pigment { rgb <0.6, 0.8, 0.4> }
}
