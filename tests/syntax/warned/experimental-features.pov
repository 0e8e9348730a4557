#version 3.7;
global_settings { assumed_gamma 1 }
camera { mesh_camera { 1 0 mesh { triangle { 0, x, y } } } }
#declare Path = spline { 0, x 1, y };
sphere { 0, 1
  pigment { slope { y altitude y } }
  finish { diffuse 0.5, 0.2 subsurface { translucency 0.3 } }
}
