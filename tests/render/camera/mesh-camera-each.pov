// povista-compat: +W80 +H60
// Rays from the faces of two meshes, averaged.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Columns = image_width;
#declare Rows = image_height;
#macro Eye(Left, Shift)
  mesh {
    #for (J, 0, Rows - 1) #for (I, 0, Columns - 1)
      #local At = <(I + 0.5)/Columns - 0.5 + Shift, 0.5 - (J + 0.5)/Rows, 0>;
      #local To = vnormalize(<At.x*1.33, At.y, 1.2 + Left>);
      #local Side = vnormalize(vcross(To, y))*0.05;
      #local Up = vnormalize(vcross(Side, To))*0.05;
      triangle { <0, 1, -4> - Side, <0, 1, -4> + Side, <0, 1, -4> + Up }
    #end #end
  }
#end
#declare First = Eye(0, 0)
#declare Second = Eye(0.1, 0.01)
camera { mesh_camera { 2 0 mesh { First } mesh { Second translate 0.05*x } } location <0, 0, 0.01> }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
plane { y, -0.6 pigment { checker rgb 0.85 rgb <0.35, 0.20, 0.15> } }

sphere { <-1, 0.2, 0>, 0.7 pigment { rgb <0.9, 0.4, 0.3> } }
box { <0.3, -0.6, -0.6>, <1.4, 0.6, 0.5> pigment { rgb <0.3, 0.5, 0.9> } }
cone { <0, -0.6, 2>, 0.7, <0, 1.6, 2>, 0 pigment { rgb <0.4, 0.8, 0.4> } }
