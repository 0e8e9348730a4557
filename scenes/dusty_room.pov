// Light through a window: sunbeams in the dust of a room, with coloured panes.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }

camera { location <-2.5, 1.75, -4.6> look_at <0.35, 1.3, 0> right x*image_width/image_height angle 62 }

#declare Sun = vnormalize(<1, 0.62, 0.12>);
light_source { 200*Sun rgb <6.4, 5.2, 3.9> parallel point_at 0 }
light_source { <-2.2, 2.8, -4> rgb <0.13, 0.14, 0.18> shadowless media_interaction off }

// The dust: a box of it, a little denser near the floor.
box { <-3.9, 0.001, -4.9>, <2.999, 3.19, 2.9>
  hollow pigment { rgbt 1 }
  interior {
    media {
      scattering { 5, <0.030, 0.027, 0.024> eccentricity 0.25 extinction 0.6 }
      samples 64 aa_level 4 aa_threshold 0.02
      density { gradient y color_map { [0 rgb 1.35] [1 rgb 0.8] } scale 3.2 }
    }
  }
}

// Walls, floor, ceiling.
#declare Plaster = texture {
  pigment { bozo turbulence 0.6 scale 0.7 color_map { [0 rgb <0.62, 0.54, 0.44>] [1 rgb <0.72, 0.65, 0.55>] } }
  normal { granite 0.08 scale 0.5 }
  finish { diffuse 0.7 ambient rgb <0.05, 0.045, 0.045> }
}
#declare Boards = texture {
  pigment { wood turbulence 0.06 octaves 3 scale <0.05, 0.05, 1.2> rotate 2*x
    color_map { [0 rgb <0.30, 0.17, 0.08>] [0.7 rgb <0.42, 0.25, 0.12>] [1 rgb <0.22, 0.12, 0.06>] } }
  finish { diffuse 0.75 specular 0.25 roughness 0.03 ambient 0.03 }
}
difference {
  box { <-4.2, -0.2, -5.2>, <3.3, 3.5, 3.2> }
  box { <-4, 0, -5>, <3, 3.2, 3> }
  box { <2.9, 0.95, -1.55>, <3.4, 2.65, -0.05> }
  box { <2.9, 0.95, 0.35>, <3.4, 2.65, 1.85> }
  hollow
  texture { Plaster }
}
#for (K, 0, 19) box { <-4, 0, -5 + 0.4*K>, <3, 0.012, -5 + 0.4*K + 0.388> texture { Boards translate <0.37*K, 0, 3*K> } } #end

// Windows: frames, crossbars, and panes of which some are coloured.
#macro Window(Low)
  union {
    box { <3.02, 0.9, Low - 0.05>, <3.2, 0.97, Low + 1.55> }
    box { <3.02, 2.63, Low - 0.05>, <3.2, 2.7, Low + 1.55> }
    box { <3.02, 0.9, Low - 0.05>, <3.2, 2.7, Low + 0.02> }
    box { <3.02, 0.9, Low + 1.48>, <3.2, 2.7, Low + 1.55> }
    box { <3.06, 0.9, Low + 0.71>, <3.14, 2.7, Low + 0.79> }
    box { <3.06, 1.46, Low>, <3.14, 1.53, Low + 1.5> }
    box { <3.06, 2.06, Low>, <3.14, 2.13, Low + 1.5> }
    pigment { rgb <0.16, 0.10, 0.06> } finish { specular 0.3 ambient 0.04 }
  }
#end
#declare Panes = array[6] { <1, 0.45, 0.25>, <0.35, 0.7, 1>, <1, 0.85, 0.4>, <0.5, 1, 0.55>, <1, 0.6, 0.75>, <0.75, 0.65, 1> }
#for (W, 0, 1)
  #local Low = -1.55 + 1.9*W;
  Window(Low)
  #for (J, 0, 2)
    #for (I, 0, 1)
      #local C = Panes[mod(2*J + I + 3*W, 6)];
      #local Clear = mod(I + J + W, 2);
      box { <3.095, 0.95 + 0.6*J, Low + 0.75*I>, <3.105, 1.5 + 0.6*J, Low + 0.75*I + 0.72>
        pigment { #if (Clear) rgbf <0.96, 0.98, 1, 0.96> #else rgbf <C.x, C.y, C.z, 0.9> #end }
        finish { diffuse 0.05 specular 0.4 } no_reflection }
    #end
  #end
#end
// The sky outside.
plane { x, 40 inverse hollow no_shadow pigment { rgb <0.95, 0.92, 0.82> } finish { emission 1 diffuse 0 } }

// A table with a jug, fruit and a book; a chair's back against the light.
#declare Oak = texture { pigment { wood turbulence 0.05 scale <0.06, 0.06, 0.6> rotate 90*y
    color_map { [0 rgb <0.36, 0.20, 0.09>] [1 rgb <0.22, 0.11, 0.05>] } } finish { specular 0.3 roughness 0.02 ambient 0.03 } }
union {
  box { <-0.75, 0.74, -0.55>, <0.75, 0.8, 0.55> }
  #for (I, -1, 1, 2) #for (J, -1, 1, 2) box { <-0.05, 0, -0.05>, <0.05, 0.75, 0.05> translate <0.62*I, 0, 0.44*J> } #end #end
  texture { Oak } rotate 12*y translate <0.2, 0, -0.3>
}
lathe { cubic_spline 9, <0, 0>, <0.09, 0>, <0.17, 0.12>, <0.16, 0.25>, <0.08, 0.36>, <0.07, 0.42>, <0.1, 0.48>, <0.11, 0.5>, <0.12, 0.52>
  pigment { rgb <0.14, 0.30, 0.42> } finish { specular 0.6 roughness 0.015 reflection 0.08 ambient 0.03 } translate <0.05, 0.8, -0.1> }
#for (K, 0, 4) sphere { 0, 0.075 pigment { rgb <0.8, 0.28 + 0.1*mod(K, 3), 0.08> } finish { phong 0.5 ambient 0.04 }
    translate <0.5 + 0.13*cos(K*1.3), 0.875, -0.35 + 0.13*sin(K*1.3)> } #end
union {
  box { <-0.17, 0, -0.12>, <0.17, 0.05, 0.12> pigment { rgb <0.55, 0.1, 0.1> } }
  box { <-0.16, 0.006, -0.125>, <0.165, 0.044, 0.115> pigment { rgb 0.85 } }
  rotate 35*y translate <-0.2, 0.8, -0.5>
}
