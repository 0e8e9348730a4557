// Columns and rings under two soft lamps that look closer only where it is worth while.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,4,-9> look_at <0,0.5,0> angle 42 }
light_source { <-8,12,-6> rgb 0.8 area_light x*3, z*3, 9, 9 adaptive 1 jitter circular orient }
light_source { <9,10,-4> rgb 0.4 area_light x*3, z*3, 5, 5 adaptive 0 jitter }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.6 } }
#for (I,0,11)
  cylinder { <0,0,0>, <0,1.6,0>, 0.15 pigment { rgb <0.8,0.7,0.5> } translate <3,0,0> rotate 30*I*y }
  torus { 0.4, 0.1 pigment { rgb <0.5,0.7,0.9> } rotate 60*x translate <1.6,0.6,0> rotate (30*I+15)*y }
#end
box { <-0.5,0,-0.5>, <0.5,1,0.5> rotate 30*y pigment { rgb <0.9,0.5,0.4> } }
