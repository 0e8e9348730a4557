// A rainbow whose edges are blurred a little at random.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -8> look_at <0, 3, 0> right x*image_width/image_height angle 90 }
background { rgb <0.45, 0.55, 0.7> }
plane { y, -1 pigment { rgb <0.4, 0.6, 0.3> } finish { emission 0.5 } }
rainbow { direction <0.1, -0.2, 1> angle 38 width 8 distance 1000 jitter 0.01
  color_map { [0 rgbt <0.6, 0, 1, 0.5>] [0.3 rgbt <0, 0.3, 1, 0.3>] [0.6 rgbt <0.3, 1, 0.2, 0.3>] [1 rgbt <1, 0.1, 0, 0.5>] } }
