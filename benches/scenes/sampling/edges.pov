// Straight and round edges of even colours on a black ground.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location -5*z look_at 0 right 4*x*image_width/image_height up 4*y }
background { rgb 0.02 }
#declare Flat = finish { ambient 0 diffuse 0 emission 1 }
#for (I, 0, 11)
  polygon { 4, <0, 0>, <0.35, 1.8>, <0.28, 1.9>, <0, 0> rotate 30*I*z pigment { rgb <1, 0.9, 0.5> } finish { Flat } }
#end
torus { 1.5, 0.05 rotate 90*x translate 0.1*z pigment { rgb <0.3, 0.6, 1> } finish { Flat } }
sphere { 0, 0.3 translate -z pigment { rgb <1, 0.3, 0.2> } finish { Flat } }
