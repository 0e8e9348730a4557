// Floors, fractals, mapping warps, object and pigment patterns, and bumps under uneven scale.
#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,6,-16> look_at <0,3.2,0> angle 45}
light_source{<-20,30,-30> rgb 1}
background{rgb <.2,.3,.4>}
#declare M=color_map{[0 rgb <.1,0,.2>][.3 rgb <.9,.6,.1>][.7 rgb <.2,.8,.4>][1 rgb 1]};
#declare P=array[12];
#declare P[0]=texture{pigment{julia <.353,.288>,35 color_map{M} scale .5} normal{spiral2 4 .8 scale .4}};
#declare P[1]=texture{pigment{pavement number_of_sides 3 number_of_tiles 5 pattern 3 exterior 1 interior 2 form 1 color_map{M} scale .3 rotate 90*x}};
#declare P[2]=texture{pigment{tiling 26 color_map{M} scale .3 rotate 90*x}};
#declare P[3]=texture{pigment{triangular scale .3 rotate 90*x}};
#declare P[4]=texture{pigment{square pigment{rgb 1} pigment{rgb x} pigment{granite} pigment{rgb y} scale .3 rotate x*90} normal{cylindrical 2 frequency 3 sine_wave}};
#declare P[5]=texture{pigment{cubic rotate 30}};
#declare P[6]=texture{pigment{boxed color_map{M} frequency 4 triangle_wave} normal{onion 2 scale .3}};
#declare P[7]=texture{pigment{object{sphere{0,.95 scale <1,.3,1> rotate 20*z} rgb x rgb y}}};
#declare P[8]=texture{pigment{pigment_pattern{bozo scale .2} color_map{M}}};
#declare P[9]=texture{pigment{checker scale .2 warp{spherical}} normal{gradient x 1 scale .1 warp{cylindrical} accuracy .01}};
#declare P[10]=texture{bozo texture_map{[0 pigment{rgb x} normal{bumps 1 scale .1}][1 pigment{rgb <.6,1,.2>} normal{wrinkles 1}]} scale <.5,2,.7> no_bump_scale};
#declare P[11]=texture{uv_mapping checker texture{pigment{rgb 1}} texture{pigment{radial frequency 6} finish{ambient .4}} scale .1};
#declare I=0;
#while(I<12) sphere{0,.9 texture{P[I]} rotate <10*I,20,0> scale <1,1,.9> translate <mod(I,5)*2.1-4.2,int(I/5)*2.1,0>} #declare I=I+1; #end
plane{y,-1.2 pigment{checker rgb .7 rgb .5}}
