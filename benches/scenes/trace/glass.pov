// A thousand balls and boxes of glass and mirrors, followed twelve levels deep.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 adc_bailout 0.001 }
camera { location <0, 6, -16> look_at 0 angle 50 }
light_source { <20, 40, -30> rgb 1 }
#declare S = seed(5);
#declare Glass = texture { pigment { rgbf <0.95, 1, 0.97, 0.9> } finish { reflection 0.1 specular 0.6 roughness 0.01 } }
#declare Mirror = texture { pigment { rgb <0.9, 0.7, 0.4> } finish { diffuse 0.2 reflection 0.7 } }
#for (I, 1, 1000)
  #local Place = <rand(S)*16 - 8, rand(S)*8 - 4, rand(S)*16 - 8>;
  #local Size = 0.15 + 0.25*rand(S);
  #if (mod(I, 2)) sphere { Place, Size
  #else box { -Size, Size rotate <90*rand(S), 90*rand(S), 0> translate Place
  #end
    #if (mod(I, 5)) texture { Glass } interior { ior 1.5 } #else texture { Mirror } #end }
#end
plane { y, -5 pigment { checker rgb 1, rgb 0.3 } }
