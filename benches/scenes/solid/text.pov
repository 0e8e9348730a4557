// Three lines of letters.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at 0 angle 42 }
light_source { <10, 20, -10> rgb 1 }
#for (I, 0, 2)
  text { ttf "timrom.ttf" "Sphinx of black quartz" 0.2, 0 scale 0.34 rotate 15*y translate <-1.6, 0.5 - 0.6*I, 0>
         pigment { rgb <0.9, 0.7, 0.3> } }
#end
