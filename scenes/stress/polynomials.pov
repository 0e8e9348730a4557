// Polynomials of degree 3 seen along an axis in which they are of degree 1: POV-Ray takes the small
// leading coefficients for zero, then finds nothing.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 5, 0> look_at 0 right 6*x up 4.5*z }
light_source { <-3, 10, 5> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
// y = x^3
polynomial { 3, xyz(3,0,0): 1, xyz(0,1,0): -1 clipped_by { box { -1, 1 } } translate -1.4*x pigment { rgb <1, 0.7, 0.3> } }
// y = x^2 z
polynomial { 3, xyz(2,0,1): 1, xyz(0,1,0): -1 clipped_by { cylinder { -2*y, 2*y, 1.2 } } translate 1.4*x pigment { rgb <0.4, 0.7, 1> } }
