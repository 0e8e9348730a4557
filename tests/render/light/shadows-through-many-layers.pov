// Shadows coloured by filter and transmit, through panes one behind the other, layers and solids in solids.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -7> look_at <0, 0.5, 0.5> right x*image_width/image_height angle 50 }
light_source { <-2, 9, -3> rgb 0.8 }
light_source { <5, 8, 2> rgb 0.4 area_light x, z, 3, 3 adaptive 0 }
plane { y, 0 pigment { rgb 0.95 } }
#for (I, 0, 7)
  box { <-2.2 + 0.25*I, 1 + 0.2*I, -0.6>, <-0.6 + 0.25*I, 1.05 + 0.2*I, 0.8> pigment { rgbft <1 - 0.08*I, 0.6 + 0.05*I, 0.9, 0.75, 0.1> } }
#end
sphere { <1.6, 0.9, 0>, 0.8
  texture { pigment { rgbt <0.9, 0.5, 0.3, 0.7> } }
  texture { pigment { checker rgbf <0.8, 1, 0.8, 0.8> rgbt <0.5, 0.5, 1, 0.9> scale 0.3 } }
}
sphere { <1.6, 0.9, 0>, 0.4 pigment { rgbf <1, 1, 0.4, 0.8> } interior { fade_distance 0.5 fade_power 2 fade_color <0.9, 0.6, 0.3> } }
