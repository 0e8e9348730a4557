// The orrery: a golden shell around a ruby, and twelve gems of glass on their pedestals.
//
// Shows CSG, reflection, refraction, coloured shadows, macros, loops and patterns.
// Render it with:  povista scenes/showcase.pov

#version 3.7;
#include "colors.inc"

global_settings {
  assumed_gamma 1
  max_trace_level 12
}

camera {
  location <0, 3.2, -11.6>
  look_at <0, 1.85, 0>
  right x*image_width/image_height
  angle 40
}

// The sky: dusk at the horizon, night above.
sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.00 rgb <0.95, 0.55, 0.30>]
      [0.12 rgb <0.75, 0.50, 0.55>]
      [0.35 rgb <0.22, 0.30, 0.55>]
      [1.00 rgb <0.03, 0.05, 0.16>]
    }
  }
}

light_source { <-9, 11, -8> rgb <1.15, 1.05, 0.90> }
light_source { <10, 6, -4> rgb <0.20, 0.25, 0.38> }
light_source { <0, 9, 7> rgb <0.35, 0.25, 0.20> }

// The floor: polished hexagons.
plane {
  y, 0
  texture {
    hexagon
    texture { pigment { rgb <0.09, 0.10, 0.14> } finish { diffuse 0.7 specular 0.4 roughness 0.01 reflection { 0.06, 0.45 } } }
    texture { pigment { rgb <0.16, 0.15, 0.17> } finish { diffuse 0.7 specular 0.4 roughness 0.01 reflection { 0.05, 0.42 } } }
    texture { pigment { rgb <0.17, 0.09, 0.08> } finish { diffuse 0.7 specular 0.4 roughness 0.01 reflection { 0.04, 0.40 } } }
    scale 0.45
  }
}

#declare GoldFinish = finish {
  ambient 0.05 diffuse 0.35 brilliance 2
  specular 0.9 roughness 0.015 metallic
  reflection { 0.35, 0.75 metallic }
}
#declare Gilt = texture { pigment { rgb <0.95, 0.68, 0.28> } finish { GoldFinish } }
#declare Marble = texture {
  pigment {
    leopard scale 0.06
    color_map { [0.0 rgb <0.84, 0.81, 0.76>] [0.5 rgb <0.74, 0.69, 0.63>] [1.0 rgb <0.52, 0.46, 0.42>] }
  }
  finish { diffuse 0.75 specular 0.25 roughness 0.03 reflection 0.04 }
}

// Glass of a hue, given in degrees.
#macro Glass(Hue)
  #local Tint = CHSL2RGB(<Hue, 0.85, 0.62, 0, 0>);
  material {
    texture {
      pigment { rgbf <Tint.red, Tint.green, Tint.blue, 0.92> }
      finish { ambient 0 diffuse 0.05 specular 0.9 roughness 0.002 reflection { 0.02, 1 fresnel } conserve_energy }
    }
    interior { ior 1.5 fade_distance 1.2 fade_power 2 fade_color rgb <Tint.red, Tint.green, Tint.blue> }
  }
#end

// A point on the unit sphere: number N of Count, spread evenly by the golden angle.
#macro Spread(N, Count)
  #local Height = 1 - 2*(N + 0.5)/Count;
  #local Around = N*137.50776405;
  (vrotate(<sqrt(1 - Height*Height), Height, 0>, y*Around))
#end

// The shell: a hollow ball with windows, and the ruby inside.
#declare Windows = 46;
union {
  difference {
    sphere { 0, 1.25 }
    sphere { 0, 1.13 }
    #for (N, 0, Windows - 1)
      cylinder { 0, 2*Spread(N, Windows), 0.225 }
    #end
    texture { Gilt }
  }
  sphere { 0, 0.62 Glass(350) }
  torus { 1.62, 0.045 rotate <18, 0, 24> texture { Gilt } }
  torus { 1.78, 0.035 rotate <-30, 0, 52> texture { Gilt } }
  translate 2.25*y
}

// What carries it: a turned column on a stepped base.
union {
  cone { 0.52*y, 0.30, 0.95*y, 0.11 }
  torus { 0.30, 0.05 translate 0.52*y }
  torus { 0.13, 0.04 translate 0.95*y }
  texture { Gilt }
}
#for (Step, 0, 2)
  cylinder { 0.17*Step*y, 0.17*(Step + 1)*y, 1.35 - 0.33*Step texture { Marble rotate 15*Step*y } }
#end

// A pedestal with its gem.
#macro Pedestal(Hue, Cut)
  union {
    difference {
      cylinder { 0, 0.50*y, 0.34 }
      #for (Flute, 0, 11)
        cylinder { <0.36, -1, 0>, <0.36, 1, 0>, 0.055 rotate 30*Flute*y }
      #end
    }
    cylinder { 0.50*y, 0.56*y, 0.38 }
    cylinder { -0.01*y, 0.07*y, 0.40 }
    texture { Marble }
  }
  #switch (Cut)
    #case (0)
      sphere { 0.90*y, 0.335 Glass(Hue) }
    #break
    #case (1)
      // A brilliant: the part common to turned boxes.
      intersection {
        #for (Turn, 0, 2)
          box { -0.33, 0.33 rotate <45, 0, 35.264> rotate 40*Turn*y }
        #end
        translate 0.92*y
        Glass(Hue)
      }
    #break
    #else
      // A lens on its edge.
      intersection {
        sphere { -0.42*z, 0.56 }
        sphere { 0.42*z, 0.56 }
        rotate 35*y
        translate 0.93*y
        Glass(Hue)
      }
  #end
#end

#declare Gems = 12;
#for (N, 0, Gems - 1)
  union {
    Pedestal(360*N/Gems, mod(N, 3))
    translate -3.75*z
    rotate (360*N/Gems + 15)*y
  }
#end

// Pearls that climb around it all.
#declare Turn = 0;
#while (Turn < 1)
  sphere {
    vrotate(<2.45 - 1.1*Turn, 0.12 + 4.0*Turn, 0>, 900*Turn*y), 0.07 - 0.04*Turn
    pigment { rgb <0.95, 0.93, 0.90> }
    finish { diffuse 0.6 specular 0.8 roughness 0.01 reflection 0.25 irid { 0.15 thickness 0.4 } }
  }
  #declare Turn = Turn + 1/160;
#end
