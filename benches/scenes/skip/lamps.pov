// A road with a hundred lamps of which the eye sees four. `Hard=1`: those behind it fade more slowly, to no
// effect that could be seen, but they have to be asked.

#version 3.7;
#ifndef (Hard) #declare Hard = 0; #end

global_settings { assumed_gamma 1 }

camera { location <0, 2, -8> look_at <0, 1, 4> right x*image_width/image_height }

plane { y, 0 pigment { checker rgb 0.3 rgb 0.5 } }

#for (I, 0, 99)
  #declare Near = (I < 4);
  #declare Place = (Near ? 3*I : -40 - 3*I);
  union {
    cylinder { 0, 3*y, 0.08 }
    box { <-0.4, 3, -0.1>, <0.1, 3.1, 0.1> }
    pigment { rgb <0.2, 0.3, 0.25> }
    translate <1.8, 0, Place>
  }
  light_source {
    <1.4, 2.9, Place>
    rgb 1.2
    fade_distance 1
    fade_power (Near ? 2 : Hard ? 4 : 12)
  }
#end

#for (I, 0, 20)
  sphere { <mod(I*1.7, 4) - 2, 0.4, I>, 0.4 pigment { rgb <0.8, 0.5, 0.2> } }
#end
