// Patterns that take lists of colours.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
light_source { <0, 0, -100> rgb 1 parallel point_at 0 }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { checker rgb 1 rgb <0.8, 0.1, 0.1> scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-1.5, 1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { checker scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-0.5, 1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { brick scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <0.5, 1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { brick rgb 0.9 rgb <0.6, 0.3, 0.2> mortar 0.3 scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <1.5, 1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { hexagon scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-1.5, 0.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { hexagon rgb 1 rgb 0.5 rgb 0.1 scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-0.5, 0.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { square scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <0.5, 0.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { triangular scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <1.5, 0.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { cubic scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-1.5, -1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { checker pigment { gradient x } pigment { rgb <0.2, 0.5, 0.3> } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <-0.5, -1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { brick brick_size <1.5, 0.8, 1> mortar 0.1 scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <0.5, -1.0, 0> }
box { <-0.47, -0.47, 0>, <0.47, 0.47, 0.5> pigment { cells color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb 1] } scale 0.3 rotate <20, 30, 10> } finish { ambient 0 diffuse 1 } translate <1.5, -1.0, 0> }
