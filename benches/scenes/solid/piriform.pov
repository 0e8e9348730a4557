// A quartic, three times.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at 0 angle 42 }
light_source { <10, 20, -10> rgb 1 }
#declare Drop = quartic {
  <4,0,0,-4,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 1,0,0,0,0, 0,0,1,0,0>
  bounded_by { box { <-0.01, -0.7, -0.7>, <1.01, 0.7, 0.7> } }
}
#for (I, -1, 1)
  object { Drop rotate (90 + 40*I)*z translate I*x pigment { rgb <0.8, 0.3, 0.3> } }
#end
