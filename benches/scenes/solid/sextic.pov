// A polynomial of degree 6: Barth's sextic, cut by a ball.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at 0 angle 42 }
light_source { <10, 20, -10> rgb 1 }
#declare T = (1 + sqrt(5))/2; #declare A = T*T; #declare B = A*A;
// 4 (T²x²-y²)(T²y²-z²)(T²z²-x²) - (1+2T)(x²+y²+z²-1)²
polynomial { 6,
  xyz(4,2,0): -4*B, xyz(4,0,2): 4*A, xyz(2,4,0): 4*A, xyz(0,4,2): -4*B, xyz(2,0,4): -4*B, xyz(0,2,4): 4*A,
  xyz(2,2,2): 4*(A*A*A - 1),
  xyz(4,0,0): -(1+2*T), xyz(0,4,0): -(1+2*T), xyz(0,0,4): -(1+2*T),
  xyz(2,2,0): -2*(1+2*T), xyz(2,0,2): -2*(1+2*T), xyz(0,2,2): -2*(1+2*T),
  xyz(2,0,0): 2*(1+2*T), xyz(0,2,0): 2*(1+2*T), xyz(0,0,2): 2*(1+2*T), xyz(0,0,0): -(1+2*T)
  clipped_by { sphere { 0, 1.7 } } bounded_by { clipped_by }
  scale 0.8 rotate <20, 30, 0> pigment { rgb <0.4, 0.6, 0.8> }
}
