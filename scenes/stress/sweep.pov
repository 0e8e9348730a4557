// B-spline and cubic sweeps of spheres whose radius changes fast: POV-Ray leaves holes and slits.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -8> direction z right 6.4*x up 4.8*y }
light_source { <-5, 8, -10> rgb 1 }
sphere_sweep {
  b_spline 6, <-2,-1,0>, 0.3, <-1,0,0>, 0.1, <0,1,0>, 0.5, <1,0,0>, 0.05, <0,-1,0.5>, 0.6, <-1,0,1>, 0.3
  scale 1.4 translate -1.4*x pigment { rgb <1, 0.6, 0.3> }
}
sphere_sweep {
  cubic_spline 6, <-2,-1,0>, 0.3, <-1,0,0>, 0.1, <0,1,0>, 0.5, <1,0,0>, 0.05, <0,-1,0.5>, 0.6, <-1,0,1>, 0.3
  scale 1.1 translate 1.5*x pigment { rgb <0.3, 0.6, 1> }
}
