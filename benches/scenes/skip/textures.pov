// Balls of agate that throw shadows on each other. `Hard=1`: a trace of transparency and of bumps, too faint to
// be seen, has them asked for their colours by shadow rays too, and has every normal bent.

#version 3.7;
#ifndef (Hard) #declare Hard = 0; #end

global_settings { assumed_gamma 1 }

camera { location <0, 6, -9> look_at <0, 0, 1> right x*image_width/image_height }

light_source { <8, 9, -6> rgb 0.7 }
light_source { <-8, 12, -3> rgb 0.6 }

plane { y, 0 pigment { granite color_map { [0 rgb 0.3] [1 rgb 0.8] } } }

#declare Trace = (Hard ? 1e-9 : 0);

#for (I, -6, 6)
  #for (J, 0, 8)
    sphere {
      <I, 0.45, J - 3>, 0.45
      pigment { agate color_map { [0 rgb <0.9, 0.6, 0.3>] [1 rgbt <0.3, 0.1, 0.1, Trace>] } scale 0.5 }
      normal { bumps Trace }
      finish { specular 0.3 }
    }
  #end
#end
