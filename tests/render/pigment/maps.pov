// Patterns that take maps.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
light_source { <0, 0, -100> rgb 1 parallel point_at 0 }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { gradient <1, 1, 0> color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-1.5, 1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { planar color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-0.5, 1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { cylindrical color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <0.5, 1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { spherical color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <1.5, 1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { boxed color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-1.5, 0.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { radial color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-0.5, 0.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { onion color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <0.5, 0.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { leopard color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <1.5, 0.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { radial frequency 5 color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-1.5, -1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { gradient y triangle_wave color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-0.5, -1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { onion sine_wave frequency 2 phase 0.3 color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <0.5, -1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { gradient x pigment_map { [0 rgb 1] [0.5 checker rgb 0 rgb 1 scale 0.2] [1 rgb <0.8, 0.2, 0.2>] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <1.5, -1.0, 0> }
