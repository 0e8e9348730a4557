// The four operations side by side, cut faces coloured by the cutter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.4, 0> right x*image_width/image_height angle 50 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

#declare A = sphere { 0, 0.7 pigment { rgb <0.9, 0.3, 0.2> } }
#declare B = box { <0, -0.5, -1>, <0.9, 0.5, 0.2> pigment { rgb <0.2, 0.5, 0.9> } }
difference { object { A } object { B } translate <-1.7, 0.2, 0> }
intersection { object { A } object { B } translate <-0.6, 0.2, 0> }
merge { object { A } object { B } pigment { rgbt <1, 1, 1, 0.6> } translate <0.5, 0.2, 0> }
union { object { A } object { B } translate <1.7, 0.2, 0.4> }
