// A sky of several pigments, brightened, turned, and seen in a mirror.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 1.2, 0> right x*image_width/image_height angle 80 }
light_source { <-8, 12, -20> rgb 1 }
background { rgb <0.2, 0.1, 0.1> }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgbt <0.2, 0.4, 0.8, 0.2>] [1 rgbf <0.1, 0.2, 0.6, 0.5>] } }
  pigment { bozo turbulence 0.4 scale <0.6, 0.2, 0.6> color_map { [0.5 rgbt 1] [0.9 rgbt <1, 1, 1, 0.1>] } }
  emission <1, 1.1, 1.2>
  rotate <10, 30, 5>
}
plane { y, -1 pigment { rgb 0.2 } finish { reflection 0.4 } }
sphere { 0, 1 pigment { rgb 0.1 } finish { reflection 0.8 } }
