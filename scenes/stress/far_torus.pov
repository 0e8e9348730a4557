// A ring as `quartic` and as `torus`, an `ovus` and a `sor`, through a telescope 10^6 away: POV-Ray's
// rays lose all digits on the way.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Far = 1e6;
camera { orthographic location <0, 0, -Far> direction z right 5.2*x up 3.9*y }
light_source { <-1, 1, -1>*Far rgb 1 parallel point_at 0 }
quartic {
  <1,0,0,0,2,0,0,2,0,-1.25, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1,0,0,0,0, 1,0,-1.25,0,0.25>
  sturm rotate 50*x translate <-0.95, 0.6, 0> pigment { rgb <1, 0.6, 0.2> }
}
torus { 0.75, 0.25 rotate 50*x translate <0.95, 0.6, 0> pigment { rgb <0.3, 0.6, 1> } }
ovus { 0.5, 0.3 translate <-0.95, -0.9, 0> pigment { rgb <0.5, 0.9, 0.4> } }
sor {
  6, <0.2,-1.5>, <0.5,-1>, <0.9,-0.4>, <0.4,0.2>, <0.6,0.9>, <0.3,2>
  scale 0.5 rotate 20*x translate <0.95, -0.8, 0> pigment { rgb <0.9, 0.4, 0.7> }
}
