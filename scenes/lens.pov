// A lens with a small depth of field: wheels of a clock and glass beads on a table, candles far behind.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }

camera {
  location <0.6, 2.3, -6.2> look_at <0.05, 0.72, 0> right x*image_width/image_height angle 34
  aperture 0.62 focal_point <-0.1, 0.45, -0.45> blur_samples 30 variance 0
}

light_source { <-5, 7, -4> rgb <0.75, 0.68, 0.6> }
light_source { <6, 4, 5> rgb <0.25, 0.32, 0.45> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.05, 0.04, 0.05>] [0.5 rgb <0.16, 0.14, 0.16>] [1 rgb <0.5, 0.48, 0.5>] } } }

plane { y, 0
  pigment { wood turbulence 0.08 octaves 4 scale <0.35, 0.35, 3> rotate <4, 25, 0>
    color_map { [0 rgb <0.26, 0.13, 0.06>] [0.6 rgb <0.36, 0.19, 0.09>] [1 rgb <0.17, 0.08, 0.04>] } }
  finish { diffuse 0.8 specular 0.3 roughness 0.02 reflection { 0.02, 0.25 } }
}

// Glass beads in rows that recede.
#declare Tints = array[7] { <1, 0.35, 0.3>, <1, 0.7, 0.25>, <0.95, 0.95, 0.4>, <0.4, 0.95, 0.5>, <0.35, 0.8, 1>, <0.5, 0.45, 1>, <0.95, 0.45, 0.9> }
#declare R = seed(5);
#for (J, 0, 5)
  #for (I, 0, 4)
    #local C = Tints[mod(I*3 + J*2, 7)];
    #local Size = 0.22 + 0.10*rand(R);
    sphere { <(I - 2)*1.25 + 0.4*(rand(R) - 0.5) + 0.35*mod(J, 2), Size, -2.1 + 1.35*J + 0.3*(rand(R) - 0.5)>, Size
      hollow pigment { rgbf <C.x, C.y, C.z, 0.92> }
      finish { diffuse 0.1 specular 0.8 roughness 0.004 reflection { 0.03, 0.7 fresnel } conserve_energy }
      interior { ior 1.5 fade_distance 0.5 fade_power 2 fade_color C caustics 0.6 } }
  #end
#end

// Two wheels of brass and steel, in focus.
#macro Wheel(Teeth, Radius, Thick)
  difference {
    union {
      cylinder { 0, Thick*y, Radius }
      #for (K, 0, Teeth - 1)
        box { <-0.05*Radius, 0, 0.9*Radius>, <0.05*Radius, Thick, 1.14*Radius> rotate 360*K/Teeth*y }
      #end
    }
    cylinder { -0.1*y, (Thick + 0.1)*y, 0.12*Radius }
    #for (K, 0, 4)
      cylinder { <0.52*Radius, -0.1, 0>, <0.52*Radius, Thick + 0.1, 0>, 0.21*Radius rotate 72*K*y }
    #end
  }
#end
#declare Brass = texture { pigment { rgb <0.80, 0.58, 0.25> }
  finish { diffuse 0.4 specular 0.8 roughness 0.02 metallic reflection { 0.35 metallic } brilliance 2 } normal { granite 0.03 scale 0.1 } }
#declare Steel = texture { pigment { rgb <0.62, 0.65, 0.70> }
  finish { diffuse 0.35 specular 0.9 roughness 0.01 metallic reflection { 0.4 metallic } } }
object { Wheel(20, 0.62, 0.11) texture { Brass } rotate <-62, 0, 12> translate <-0.5, 0.68, -0.35> }
object { Wheel(14, 0.40, 0.10) texture { Steel } rotate <-62, 12, 0> rotate 20*y translate <0.55, 0.46, -0.55> }
sphere { <0.05, 0.13, -1.05>, 0.13 texture { Steel } }

// Candles far behind, out of focus.
#for (K, 0, 6)
  #local X = -3.6 + 1.25*K; #local Z = 7.6 + 0.8*sin(2.3*K); #local H = 0.35 + 0.6*abs(sin(1.7*K));
  cylinder { <X, 0, Z>, <X, H, Z>, 0.16 pigment { rgb <0.85, 0.78, 0.62> } finish { emission 0.12 } }
  sphere { 0, 1 scale <0.09, 0.22, 0.09> translate <X, H + 0.26, Z> pigment { rgb <1, 0.72, 0.3> } finish { emission 9 diffuse 0 } no_shadow }
#end
