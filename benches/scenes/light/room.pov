// A furnished room below a square lamp of 81 places.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,2,-5.5> look_at <0,1.2,0> angle 60 }
light_source { <0,3.8,0> rgb 0.9 area_light x*1.2, z*1.2, 9, 9 fade_distance 4 fade_power 2 }
box { <-3,0,-6>, <3,4,3> pigment { rgb 0.9 } }
#macro TABLE()
  union {
    box { <-0.8,0.7,-0.5>, <0.8,0.78,0.5> }
    #for (X,-1,1,2) #for (Z,-1,1,2) cylinder { <X*0.7,0,Z*0.4>, <X*0.7,0.7,Z*0.4>, 0.04 } #end #end
    pigment { rgb <0.6,0.4,0.2> }
  }
#end
object { TABLE() translate <-0.9,0,0.4> } object { TABLE() rotate 70*y translate <1.4,0,1> }
#for (I,0,9) sphere { <-1.4+0.13*I,0.84,0.4+0.2*sin(I*2)>, 0.06 pigment { rgb <0.9,0.3+0.05*I,0.2> } } #end
difference { sphere { <1.4,1.1,1>, 0.32 } sphere { <1.4,1.3,0.9>, 0.3 } pigment { rgb <0.4,0.6,0.8> } finish { phong 0.6 } }
cone { <-2.4,0,1.8>, 0.5, <-2.4,1.9,1.8>, 0.1 pigment { rgb <0.3,0.6,0.4> } }
