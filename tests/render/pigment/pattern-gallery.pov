// Twenty spheres: patterns as pigments and as normals, maps, averages, layers and warps.
#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,6,-16> look_at <0,3.2,0> angle 45}
light_source{<-20,30,-30> rgb 1}
background{rgb <.2,.3,.4>}
#declare P=array[20];
#declare P[0]=texture{pigment{bozo turbulence 0.5 scale 0.4}};
#declare P[1]=texture{pigment{granite} normal{granite 0.4 scale 0.5}};
#declare P[2]=texture{pigment{marble turbulence 1.2 scale .5} finish{phong .8}};
#declare P[3]=texture{pigment{wood turbulence 0.1 scale .3 rotate 20} normal{wrinkles 0.7 scale .3}};
#declare P[4]=texture{pigment{agate scale .6}};
#declare P[5]=texture{pigment{crackle scale .4 color_map{[0 rgb 0][.1 rgb <1,.8,.3>][1 rgb 1]}} normal{crackle 0.6 scale .4}};
#declare P[6]=texture{pigment{leopard scale .1 color_map{[0 rgb x][1 rgb y]}} normal{dents 2 scale .2}};
#declare P[7]=texture{pigment{hexagon pigment{rgb x} pigment{checker rgb 1 rgb 0 scale .1} pigment{rgb z} scale .4}};
#declare P[8]=texture{checker texture{pigment{rgb .9} finish{reflection .3}} texture{pigment{rgb <.2,.6,.2>} normal{bumps .8 scale .1}} scale .5};
#declare P[9]=texture{gradient y texture_map{[0 pigment{rgb <1,.2,.2>} finish{phong 1}][.5 pigment{granite}][1 pigment{rgb <.2,.2,1>}]} turbulence .3 scale 1.4};
#declare P[10]=texture{pigment{slope y color_map{[0 rgb x][.5 rgb y][1 rgb z]}} normal{ripples .6 frequency 8}};
#declare P[11]=texture{pigment{aoi color_map{[.5 rgb 0][1 rgb <1,.9,.2>]}} normal{quilted 1 scale .4}};
#declare P[12]=texture{pigment{rgb .8}} texture{pigment{spiral1 4 color_map{[0 rgbt 1][.5 rgbf <1,0,0,.5>][1 rgb 1]} scale .5}};
#declare P[13]=texture{pigment{mandel 40 scale .6 translate <.5,0,0> color_map{[0 rgb 0][.2 rgb x][.5 rgb y][1 rgb 1]}}};
#declare P[14]=texture{pigment{average pigment_map{[1 bozo scale .3][2 gradient x scale .3]}} normal{average normal_map{[1 bumps 1 scale .1][1 facets coords .5 size .2]}}};
#declare P[15]=texture{pigment{function{sin(x*9)*sin(y*9)*sin(z*9)} color_map{[0 rgb 0][1 rgb <.3,1,1>]}} normal{waves .5 frequency 6}};
#declare P[16]=texture{pigment{brick brick_size <.8,.3,.4> mortar .05} normal{brick .5 brick_size <.8,.3,.4> mortar .05}};
#declare P[17]=texture{pigment{tiling 8 scale .3 color_map{[0 rgb 1][.5 rgb <.5,.1,.1>][1 rgb 0]} rotate 90*x}};
#declare P[18]=texture{pigment{cells scale .25} normal{bozo 2 scale .2 slope_map{[0 <0,1>][.5 <1,0>][1 <0,-1>]}} scale <1,2,1>};
#declare P[19]=texture{pigment{wrinkles scale .5 warp{repeat x*.5 flip x} warp{black_hole <.2,.3,-1>,.8}} finish{diffuse .8 specular .4 metallic}};
#declare I=0;
#while(I<20) sphere{0,.9 texture{P[I]} rotate <10*I,20,0> translate <mod(I,5)*2.1-4.2,int(I/5)*2.1,0>} #declare I=I+1; #end
plane{y,-1.2 pigment{checker rgb .7 rgb .5}}
