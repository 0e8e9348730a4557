// povista-compat: +W320 +H240
// Every pattern of the language: as a pigment on a tile, as pigment and bumps on a ball.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, -0.22, -58> look_at <0, -0.22, 0> right x*4/3 up y angle 18.2 }
light_source { <-25, 32, -60> rgb <1, 0.96, 0.88>*0.95 }
light_source { <35, -10, -50> rgb <0.35, 0.42, 0.6>*0.5 shadowless }

// The wall they hang on.
plane { -z, -0.5
  pigment { granite color_map { [0 rgb <0.055, 0.06, 0.075>] [1 rgb <0.095, 0.1, 0.12>] } scale 3 }
  normal { granite 0.05 scale 2 }
}

#declare Ember = color_map { [0 rgb <0.09, 0.02, 0.05>] [0.35 rgb <0.55, 0.09, 0.06>] [0.7 rgb <0.95, 0.45, 0.1>] [1 rgb <1, 0.88, 0.55>] }
#declare Ocean = color_map { [0 rgb <0.01, 0.04, 0.12>] [0.4 rgb <0.03, 0.25, 0.45>] [0.75 rgb <0.2, 0.65, 0.7>] [1 rgb <0.9, 0.97, 0.9>] }
#declare Moss = color_map { [0 rgb <0.03, 0.06, 0.03>] [0.45 rgb <0.14, 0.3, 0.1>] [0.8 rgb <0.6, 0.65, 0.2>] [1 rgb <0.97, 0.94, 0.7>] }
#declare Plum = color_map { [0 rgb <0.06, 0.02, 0.1>] [0.4 rgb <0.35, 0.08, 0.35>] [0.75 rgb <0.85, 0.4, 0.5>] [1 rgb <1, 0.9, 0.82>] }

#declare Ink = rgb <0.05, 0.07, 0.13>;
#declare Sand = rgb <0.93, 0.84, 0.62>;
#declare Clay = rgb <0.72, 0.24, 0.12>;
#declare Teal = rgb <0.1, 0.45, 0.48>;
#declare Leaf = rgb <0.35, 0.5, 0.16>;
#declare Rose = rgb <0.85, 0.45, 0.5>;

#declare Columns = 8;
#declare Shown = 0;
#macro Exhibit(Name, P, N)
  #local Column = mod(Shown, Columns);
  #local Row = int(Shown/Columns);
  #local Place = <2.1*(Column - 3.5), 2.2*(2.5 - Row), 0>;
  #local Gloss = finish { ambient 0.1 diffuse 0.8 specular 0.25 roughness 0.03 };
  box { <-0.9, -0.9, 0>, <0.9, 0.9, 0.3> pigment { P } finish { Gloss } translate Place }
  sphere { 0, 0.42 pigment { P } normal { N } finish { Gloss phong 0.5 phong_size 60 } translate Place + <0.5, -0.5, -0.5> }
  #local Label = text { ttf "cyrvetic.ttf" Name 0.02, 0 }
  #local Middle = (min_extent(Label) + max_extent(Label))/2;
  object { Label translate <-Middle.x, 0, 0> scale 0.25 translate Place + <0, -1.13, 0.2>
    pigment { rgb <0.75, 0.72, 0.66> } finish { ambient 0.5 diffuse 0.4 } no_shadow }
  #declare Shown = Shown + 1;
#end

Exhibit("agate", pigment { agate scale 0.9 color_map { Ember } }, normal { agate 0.3 scale 0.4 })
Exhibit("aoi", pigment { aoi frequency 5 triangle_wave color_map { Ocean } }, normal { aoi 0.4 })
Exhibit("average", pigment { average pigment_map { [1 gradient x triangle_wave scale 0.4 color_map { Moss }] [1 gradient y triangle_wave scale 0.4 color_map { Ember }] } },
  normal { average normal_map { [1 bumps 1 scale 0.1] [1 gradient x 1 triangle_wave scale 0.1] } })
Exhibit("boxed", pigment { boxed frequency 3 triangle_wave color_map { Plum } scale 1.6 }, normal { boxed 0.5 frequency 5 sine_wave })
Exhibit("bozo", pigment { bozo turbulence 0.5 color_map { Ember } scale 0.4 }, normal { bozo 0.8 scale 0.1 })
Exhibit("brick", pigment { brick Sand, Clay brick_size <0.6, 0.26, 0.4> mortar 0.04 }, normal { brick 0.4 brick_size <0.6, 0.26, 0.4> mortar 0.04 })
Exhibit("bumps", pigment { bumps color_map { Moss } scale 0.25 }, normal { bumps 0.8 scale 0.08 })
Exhibit("cells", pigment { cells color_map { Plum } scale 0.3 translate 0.01 }, normal { cells 0.4 scale 0.15 })

Exhibit("checker", pigment { checker Ink, Sand scale 0.3 translate 0.013 }, normal { checker 0.3 scale 0.15 })
Exhibit("crackle", pigment { crackle color_map { Ocean } scale 0.4 }, normal { crackle 0.6 scale 0.2 })
Exhibit("crackle solid", pigment { crackle solid color_map { Ember } scale 0.3 }, normal { crackle 0.6 form <1, 0, 0> scale 0.2 })
Exhibit("cubic", pigment { cubic Clay, Teal, Sand, Leaf, Rose, Ink rotate <35, 45, 0> }, normal { cubic 0.3 rotate <35, 45, 0> })
Exhibit("cylindrical", pigment { cylindrical frequency 4 sine_wave color_map { Moss } rotate x*90 scale 1.1 }, normal { cylindrical 0.5 frequency 4 sine_wave rotate x*90 })
Exhibit("density_file", pigment { density_file df3 "patterns.df3" interpolate 1 color_map { Plum } translate -0.5 scale 1.8 }, normal { density_file df3 "patterns.df3" 0.5 interpolate 1 translate -0.5 })
Exhibit("dents", pigment { dents color_map { Ember } scale 0.15 poly_wave 0.5 }, normal { dents 1.5 scale 0.12 })
Exhibit("facets", pigment { bozo color_map { Ocean } scale 0.6 }, normal { facets coords 0.6 size 0.15 })

Exhibit("function", pigment { function { 0.5 + 0.25*(sin(7*x + 3*sin(4*y)) + sin(7*y + 3*sin(4*x))) } color_map { Plum } }, normal { function { sin(20*x)*sin(20*y)*sin(20*z) } 0.2 })
Exhibit("gradient", pigment { gradient <1, 1, 0> triangle_wave color_map { Ocean } scale 0.7 }, normal { gradient y 0.4 triangle_wave scale 0.15 })
Exhibit("granite", pigment { granite color_map { Moss } scale 0.8 }, normal { granite 0.3 scale 0.4 })
Exhibit("hexagon", pigment { hexagon Sand, Clay, Teal rotate x*90 scale 0.25 translate <0.01, 0.02, 0> }, normal { hexagon 0.3 rotate x*90 scale 0.12 })
Exhibit("image_pattern", pigment { image_pattern { function 48, 48 { pattern { leopard scale 0.04 } } interpolate 2 } color_map { Ember } translate -0.5 scale 1.81 }, normal { image_pattern { function 48, 48 { pattern { leopard scale 0.04 } } interpolate 2 } 0.6 scale 0.8 })
Exhibit("julia", pigment { julia <-0.745, 0.113>, 60 color_map { [0 rgb <0.02, 0.02, 0.08>] [0.15 rgb <0.3, 0.1, 0.5>] [0.4 rgb <0.9, 0.5, 0.3>] [1 rgb <1, 0.95, 0.8>] } scale 0.65 rotate z*30 }, normal { julia <-0.745, 0.113>, 15 0.3 scale 0.4 })
Exhibit("leopard", pigment { leopard color_map { Ember } scale 0.06 }, normal { leopard 0.5 scale 0.05 })
Exhibit("magnet 1", pigment { magnet 1 mandel 30 color_map { [0 rgb <0.01, 0.04, 0.1>] [0.2 rgb <0.1, 0.4, 0.6>] [0.5 rgb <0.8, 0.9, 0.6>] [1 rgb 0.02] } translate -x*1.2 scale 0.42 }, normal { magnet 1 mandel 12 0.3 scale 0.3 })

Exhibit("magnet 2", pigment { magnet 2 mandel 30 color_map { [0 rgb <0.05, 0.01, 0.08>] [0.2 rgb <0.5, 0.15, 0.4>] [0.5 rgb <0.95, 0.75, 0.5>] [1 rgb 0.02] } translate -x*1.2 scale 0.42 }, normal { magnet 2 mandel 12 0.3 scale 0.3 })
Exhibit("mandel", pigment { mandel 60 color_map { [0 rgb <0.02, 0.04, 0.08>] [0.1 rgb <0.1, 0.3, 0.2>] [0.3 rgb <0.8, 0.8, 0.3>] [0.999 rgb 1] [1 rgb 0.01] } translate x*0.6 scale 0.72 }, normal { mandel 15 0.3 translate x*0.6 scale 0.4 })
Exhibit("marble", pigment { marble turbulence 0.8 color_map { Plum } scale 0.6 }, normal { marble 0.3 turbulence 0.5 scale 0.2 })
Exhibit("object", pigment { object { union { torus { 0.5, 0.14 rotate x*90 } torus { 0.25, 0.08 rotate x*90 } } Ink, Sand } }, normal { object { torus { 0.3, 0.1 rotate x*90 translate -z*0.3 } } 0.4 })
Exhibit("onion", pigment { onion triangle_wave frequency 2 turbulence 0.1 color_map { Ocean } scale 0.6 }, normal { onion 0.4 sine_wave scale 0.12 })
Exhibit("pavement", pigment { pavement number_of_sides 6 number_of_tiles 4 pattern 3 color_map { Moss } rotate x*90 scale 0.17 }, normal { pavement 0.3 number_of_sides 6 number_of_tiles 4 pattern 3 rotate x*90 scale 0.12 })
Exhibit("pigment_pattern", pigment { pigment_pattern { hexagon rgb 0, rgb 0.5, rgb 1 rotate x*90 scale 0.3 } turbulence 0.2 color_map { Ember } }, normal { pigment_pattern { checker rgb 0, rgb 1 scale 0.1 } 0.3 })
Exhibit("planar", pigment { planar frequency 4 sine_wave turbulence 0.25 color_map { Ocean } }, normal { planar 0.4 frequency 6 sine_wave })

Exhibit("quilted", pigment { quilted control0 0.4 control1 0.2 color_map { Plum } scale 0.45 }, normal { quilted 0.8 control0 0.3 control1 1 scale 0.25 })
Exhibit("radial", pigment { radial frequency 7 sine_wave color_map { Moss } rotate x*90 }, normal { radial 0.4 frequency 14 sine_wave rotate x*90 })
Exhibit("ripples", pigment { ripples frequency 3 color_map { Ocean } scale 0.5 }, normal { ripples 0.6 frequency 8 scale 0.4 })
Exhibit("slope", pigment { slope { <0.4, 1, -0.6> } frequency 4 triangle_wave color_map { Ember } }, normal { bumps 0.6 scale 0.12 })
Exhibit("spherical", pigment { spherical frequency 4 sine_wave color_map { Plum } scale 1.2 }, normal { spherical 0.5 frequency 6 sine_wave translate -z*0.4 })
Exhibit("spiral1", pigment { spiral1 3 color_map { Ocean } scale 0.5 }, normal { spiral1 4 0.3 scale 0.2 })
Exhibit("spiral2", pigment { spiral2 4 color_map { Ember } scale 0.5 }, normal { spiral2 4 0.3 scale 0.2 })
Exhibit("spotted", pigment { spotted color_map { Moss } scale 0.18 }, normal { spotted 0.8 scale 0.1 })

Exhibit("square", pigment { square Sand, Clay, Ink, Teal rotate x*90 scale 0.28 translate 0.011 }, normal { square 0.3 rotate x*90 scale 0.14 })
Exhibit("tiling 14", pigment { tiling 14 color_map { Plum } rotate x*90 scale 0.3 translate <0.01, 0.02, 0> }, normal { tiling 14 0.3 rotate x*90 scale 0.2 })
Exhibit("tiling 22", pigment { tiling 22 color_map { Moss } rotate x*90 scale 0.25 translate <0.01, 0.02, 0> }, normal { tiling 22 0.3 rotate x*90 scale 0.2 })
Exhibit("tiling 25", pigment { tiling 25 color_map { Ocean } rotate x*90 scale 0.3 translate <0.01, 0.02, 0> }, normal { tiling 25 0.3 rotate x*90 scale 0.2 })
Exhibit("triangular", pigment { triangular Clay, Sand, Teal, Ink, Leaf, Rose rotate x*90 scale 0.4 translate 0.01 }, normal { triangular 0.3 rotate x*90 scale 0.2 })
Exhibit("waves", pigment { waves frequency 2 color_map { Ember } scale 0.3 }, normal { waves 0.15 frequency 6 scale 0.4 })
Exhibit("wood", pigment { wood turbulence 0.08 color_map { [0 rgb <0.45, 0.22, 0.09>] [0.6 rgb <0.72, 0.45, 0.2>] [1 rgb <0.3, 0.13, 0.05>] } scale 0.25 rotate <8, 85, 0> }, normal { wood 0.2 turbulence 0.08 scale 0.12 rotate <8, 85, 0> })
Exhibit("wrinkles", pigment { wrinkles color_map { Plum } scale 0.4 }, normal { wrinkles 0.5 scale 0.15 })
