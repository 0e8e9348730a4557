// Beams of light in even dust. `Hard=1`: the same density, told by a function, has to be sampled.

#version 3.7;
#ifndef (Hard) #declare Hard = 0; #end

global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -7> look_at <0, 1.2, 0> right x*image_width/image_height }

light_source { <-6, 7, 4> rgb 1.2 spotlight radius 12 falloff 16 point_at <0, 1, 0> }

plane { y, 0 pigment { rgb 0.5 } }

#for (I, -2, 2)
  box { <I - 0.15, 0, -0.2>, <I + 0.15, 2.5, 0.2> pigment { rgb <0.6, 0.4, 0.3> } }
#end

box {
  <-5, -0.01, -5>, <5, 6, 5>
  hollow
  pigment { rgbt 1 }
  interior {
    media {
      emission 0.02
      absorption 0.05
      samples 20, 20
      #if (Hard) density { function { 1 } color_map { [0 rgb 0] [1 rgb 1] } } #end
    }
  }
}
