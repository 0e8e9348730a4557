// Clockwork: gears that really mesh, cut by CSG in loops and driven by the clock.
//
// Shows nested differences, macros with parameters, transforms and a texture given to a whole solid.
// A still:      povista scenes/gears.pov
// Animated:     povista scenes/gears.pov +KFF24 +KC

#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <2.2, 6.5, -7.5>
  look_at <0.35, -0.2, 0.1>
  right x*image_width/image_height
  angle 42
}
light_source { <-8, 14, -6> rgb <1.1, 1.0, 0.9> }
light_source { <9, 5, -3> rgb <0.15, 0.20, 0.30> }
background { rgb <0.05, 0.06, 0.08> }

plane {
  y, -0.35
  pigment { square rgb <0.16, 0.17, 0.19>, rgb <0.18, 0.19, 0.21>, rgb <0.15, 0.16, 0.18>, rgb <0.19, 0.20, 0.22> scale 0.7 }
  finish { diffuse 0.8 specular 0.2 roughness 0.05 reflection { 0.02, 0.2 } }
}

#declare Module = 0.2;    // pitch radius of one tooth pair over pi: what gears must share to mesh

#declare Brass = texture {
  pigment { rgb <0.78, 0.57, 0.24> }
  finish { ambient 0.05 diffuse 0.4 brilliance 2 specular 0.7 roughness 0.03 metallic reflection { 0.12, 0.3 metallic } }
}
#declare Steel = texture {
  pigment { rgb <0.55, 0.58, 0.62> }
  finish { ambient 0.05 diffuse 0.45 specular 0.6 roughness 0.02 metallic reflection { 0.1, 0.3 } }
}

// A gear in the x-z plane around the y axis, its first gap at angle Start (degrees).
#macro Gear(Teeth, Spokes, Start, Thick)
  #local Pitch = Module*Teeth/2;
  difference {
    cylinder { 0, Thick*y, Pitch + 0.8*Module }
    #for (N, 0, Teeth - 1)
      // A gap: narrow at the root, wide at the rim.
      Gap(Pitch, Thick, Start + 360*N/Teeth)
    #end
    #if (Spokes > 0)
      difference {
        cylinder { -0.01*y, (Thick + 0.01)*y, Pitch - 1.5*Module }
        cylinder { -0.02*y, (Thick + 0.02)*y, 0.32*Pitch }
        #for (N, 0, Spokes - 1)
          box { <0, -1, -0.085*Pitch>, <2*Pitch, 1, 0.085*Pitch> rotate 360/Spokes*N*y }
        #end
      }
    #end
    cylinder { -y, y, 0.14 + 0.05*Pitch }
  }
#end

#macro Gap(Pitch, Thick, Angle)
  intersection {
    plane { vrotate(z, -16*y), 0.78*Module translate Pitch*x }
    plane { vrotate(-z, 16*y), 0.78*Module translate Pitch*x }
    plane { -x, -(Pitch - 0.9*Module) }
    plane { x, Pitch + 2*Module }
    rotate Angle*y
  }
#end

// A gear on its axle at <X, 0, Z>.
#macro Wheel(Teeth, Spokes, X, Z, Start, Tex)
  union {
    object { Gear(Teeth, Spokes, Start, 0.3) texture { Tex } }
    cylinder { -0.35*y, 0.5*y, 0.13 + 0.05*Module*Teeth/2 texture { Steel } }
    sphere { 0.5*y, 0.12 scale <1, 0.5, 1> translate 0.25*y texture { Brass } }
    translate <X, 0, Z>
  }
#end

#declare Turn = 360*clock/24;
Wheel(24, 5, 0, 0, Turn, Brass)
Wheel(12, 0, Module*18, 0, 15 + 180 - 2*Turn, Steel)
Wheel(16, 4, -Module*20*cos(pi/3), Module*20*sin(pi/3), 120 - 360/32 - 1.5*Turn + 180, Steel)
Wheel(10, 0, -Module*17*cos(pi/4), -Module*17*sin(pi/4), 45 + 18 - 2.4*Turn, Brass)
