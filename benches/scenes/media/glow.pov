// Balls of even smoke and fire, one in another.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,2,-8> look_at 0 angle 45 }
background { rgb <0.2,0.3,0.4> }
light_source { <-6,9,-6> rgb 1 }
plane { y, -1.5 pigment { checker rgb 0.9 rgb 0.5 } }
#for (I,0,8)
  sphere { <mod(I,3)*1.8-1.8, div(I,3)*1.2-0.6, 0>, 0.9 hollow pigment { rgbt 1 }
    interior { media { absorption 0.3 emission <0.3,0.2,0.1> scattering { 1+mod(I,5), 0.4 } } } }
#end
