// A tile of green glass 7e-7 above the floor, and a pane of glass with a note glued behind it: POV-Ray
// drops what is nearer than 1e-4 behind a clear surface, and sees through the floor.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -4> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, 0 pigment { checker rgb <1, 0.25, 0.2>, rgb <0.85, 0.15, 0.1> scale 0.5 } }
box { <-1, -1, -1>, <1, 7e-7, 1> pigment { rgbt <0.4, 1, 0.5, 0.8> } }
union {
  box { <-0.6, 0.4, 0>, <0.6, 1.2, 1e-5> pigment { rgbt <1, 1, 1, 0.9> } }
  box { <-0.3, 0.55, 5e-5>, <0.3, 1.05, 1e-3> pigment { rgb <0.1, 0.3, 0.9> } finish { ambient 0.4 } }
}
