// parametric: a ball with its poles, a saddle cut by its box, a screw, and textures at u and v.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0, 0> right x*image_width/image_height angle 75 }
light_source { <-6, 8, -7> rgb 1 }
background { rgb <0.30, 0.42, 0.60> }
#default { pigment { rgb <0.9, 0.6, 0.3> } finish { specular 0.5 } }

parametric {
  function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { cos(u) }
  <0, 0>, <2*pi, pi> contained_by { sphere { 0, 1.1 } } accuracy 0.0005
  uv_mapping pigment { checker rgb 0.9 rgb <0.6, 0.2, 0.1> scale 0.3 } translate <-2, 0.5, 0>
}
parametric {
  function { u }, function { u*v }, function { v }
  <-1, -1>, <1, 1> contained_by { box { <-1, -0.6, -1>, <1, 0.6, 1> } } accuracy 0.0005
  precompute 10 x, y, z translate <2, 0.5, 0>
}
parametric {
  function { (0.6 + 0.2*cos(v))*cos(u) }, function { u*0.15 + 0.2*sin(v) - 1 }, function { (0.6 + 0.2*cos(v))*sin(u) }
  <0, 0>, <4*pi, 2*pi> contained_by { box { <-1, -1.5, -1>, <1, 1.5, 1> } } accuracy 0.0005 translate -0.5*z
}
