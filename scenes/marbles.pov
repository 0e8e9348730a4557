// A bowl of marbles: a hundred and more spheres dropped at random, some of them glass.
//
// Shows rand and seed, nested loops, arrays, trace() to let things rest on each other, and clipping.

#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1 max_trace_level 8 }

camera {
  location <0, 5.2, -6.4>
  look_at <0, 0.35, 0>
  right x*image_width/image_height
  angle 40
}
light_source { <-6, 10, -5> rgb 1.1 }
light_source { <5, 7, 4> rgb <0.25, 0.28, 0.35> shadowless }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.75, 0.80, 0.88>] [1 rgb <0.25, 0.42, 0.72>] } }
}

plane {
  y, -1
  pigment { brick rgb 0.62 rgb <0.50, 0.30, 0.22> brick_size <2.4, 1.2, 0.8> mortar 0.06 scale 0.5 rotate 90*x }
  finish { diffuse 0.8 }
}

// The bowl: a thick shell, cut off above, with a rounded rim.
#declare Bowl = union {
  difference {
    sphere { 0, 2.1 }
    sphere { 0, 2.0 }
    plane { -y, -0.55 }
  }
  torus { sqrt(2.05*2.05 - 0.55*0.55), 0.05 translate 0.55*y }
  scale <1, 0.5, 1>
}
object {
  Bowl
  pigment { rgb <0.90, 0.93, 0.95> }
  finish { diffuse 0.6 specular 0.6 roughness 0.01 reflection { 0.03, 0.5 fresnel } }
  interior { ior 1.5 }
}

#declare Colours = array[7] { Scarlet, Orange, Gold, LimeGreen, SkyBlue, MediumSlateBlue, Flesh }
#declare Floor = sphere { 0, 2.0 scale <1, 0.5, 1> inverse }
#declare Random = seed(1963);

// Each marble falls where it finds the bowl, in rings that fill up.
#declare Ring = 0;
#while (Ring < 7)
  #declare Count = max(1, int(6.1*Ring));
  #for (N, 1, Count)
    #local Radius = 0.13 + 0.035*rand(Random);
    #local Out = 0.29*Ring + 0.03*rand(Random);
    #local Above = vrotate(<Out, 3, 0>, 360*(N + 0.3*rand(Random))/Count*y);
    #local Normal = <0, 0, 0>;
    #local Rest = trace(Floor, <Above.x, 0, Above.z>, -y, Normal);
    sphere {
      Rest + vnormalize(<-Rest.x, -4*Rest.y, -Rest.z>)*Radius, Radius
      #local Colour = Colours[int(7*rand(Random))];
      #if (rand(Random) < 0.4)
        pigment { rgbf <Colour.red, Colour.green, Colour.blue, 0.8> }
        finish { diffuse 0.2 specular 0.9 roughness 0.003 reflection { 0, 0.8 fresnel } }
        interior { ior 1.45 }
      #else
        pigment {
          gradient y triangle_wave
          color_map { [0.35 rgb Colour] [0.40 rgb 0.95] [0.60 rgb 0.95] [0.65 rgb Colour*0.5] }
          scale 2*Radius rotate 360*<rand(Random), rand(Random), rand(Random)> translate Rest
        }
        finish { diffuse 0.7 specular 0.7 roughness 0.008 reflection 0.08 }
      #end
    }
  #end
  #declare Ring = Ring + 1;
#end
