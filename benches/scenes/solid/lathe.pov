// A vase of cubic pieces, and one of Bezier's.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at 0 angle 42 }
light_source { <10, 20, -10> rgb 1 }
lathe { cubic_spline 8, <0.1,-1.3>, <0.5,-1>, <0.7,-0.4>, <0.4,0.1>, <0.3,0.5>, <0.5,0.9>, <0.45,1>, <0.3,1.1>
        translate -0.9*x pigment { rgb <0.5, 0.6, 0.9> } }
lathe { bezier_spline 8, <0,-1>, <0.9,-1>, <0.9,0>, <0.3,0.1>, <0.3,0.1>, <0.1,0.3>, <0.7,0.8>, <0,0.9>
        translate 0.9*x pigment { rgb <0.9, 0.6, 0.5> } }
