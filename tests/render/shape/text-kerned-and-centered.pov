// Pairs that are kerned, and texts moved by their extents.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -7> look_at 0 right x*image_width/image_height angle 45 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }

#macro Centered(Letters, Height)
  object { Letters translate -(min_extent(Letters) + max_extent(Letters))/2 + y*Height pigment { rgb <0.9, 0.5, 0.2> } }
#end
#declare Times = text { ttf "timrom.ttf" "Testy, AVA To" 0.3, 0 }
#declare Crystal = text { ttf "crystal.ttf" "jigsaw" 0.3, 0 }
#declare Cyrvetic = text { ttf "cyrvetic.ttf" "LT. Wave j" 0.3, 0.1*x }
Centered(Times, 1)
Centered(Crystal, 0)
Centered(Cyrvetic, -1)
