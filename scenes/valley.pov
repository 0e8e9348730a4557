// A valley at dawn: ground fog between wooded hills, haze over all of it, a first bow of light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

camera { location <0, 5.2, -16> look_at <0.5, 3.4, 6> right x*image_width/image_height angle 54 }

#declare Sun = vnormalize(<0.62, 0.2, 1>);
light_source { 1000*Sun rgb <1.9, 1.35, 0.9> parallel point_at 0 }
light_source { <-60, 90, -50> rgb <0.10, 0.13, 0.20> shadowless }

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.00 rgb <1.0, 0.72, 0.42>]
      [0.10 rgb <0.86, 0.66, 0.56>]
      [0.30 rgb <0.42, 0.52, 0.70>]
      [0.80 rgb <0.13, 0.24, 0.48>]
    }
  }
  pigment {
    wrinkles turbulence 0.5 lambda 2.4 scale <0.9, 0.12, 0.9>
    color_map { [0.45 rgbt 1] [0.75 rgbt <1.0, 0.80, 0.66, 0.35>] [1 rgbt <1, 0.9, 0.8, 0.1>] }
    rotate 20*y
  }
}

// The ground: ridges on both sides, a floor that rises to the back.
#declare Height = function { pattern { granite scale 1.4 } }
#declare Land = function(x, z) {
  0.020*x*x + 0.35*sin(0.5*x + 0.21*z) + 1.1*sin(0.11*z + 0.6)*min(1, 0.02*x*x) + 0.015*max(0, z)*abs(x)*0.25
    + 1.6*(Height(0.06*x, 0.31, 0.06*z) - 0.5)*min(1, 0.15 + 0.03*x*x)
}
#declare Edge = 46;
#declare Steps = 90;
#declare Ground = mesh {
  #for (J, 0, Steps - 1)
    #for (I, 0, Steps - 1)
      #local X0 = -Edge + 2*Edge*I/Steps;  #local X1 = -Edge + 2*Edge*(I + 1)/Steps;
      #local Z0 = -16 + 96*J/Steps;        #local Z1 = -16 + 96*(J + 1)/Steps;
      triangle { <X0, Land(X0, Z0), Z0>, <X1, Land(X1, Z0), Z0>, <X1, Land(X1, Z1), Z1> }
      triangle { <X0, Land(X0, Z0), Z0>, <X1, Land(X1, Z1), Z1>, <X0, Land(X0, Z1), Z1> }
    #end
  #end
  pigment {
    bozo scale 3 turbulence 0.7
    color_map { [0 rgb <0.10, 0.14, 0.05>] [0.6 rgb <0.20, 0.21, 0.08>] [1 rgb <0.30, 0.24, 0.12>] }
  }
  normal { bumps 0.6 scale 0.3 }
}
object { Ground }

// Firs: cones on stems, denser on the slopes.
#declare Fir = union {
  cylinder { 0, 0.4*y, 0.06 pigment { rgb <0.20, 0.13, 0.08> } }
  #for (K, 0, 4) cone { (0.25 + 0.32*K)*y, 0.42 - 0.07*K, (0.85 + 0.32*K)*y, 0.02 } #end
  pigment { bozo scale 0.2 color_map { [0 rgb <0.03, 0.09, 0.05>] [1 rgb <0.07, 0.15, 0.07>] } }
}
#declare R = seed(11);
#for (K, 1, 420)
  #local X = (rand(R) - 0.5)*2*26;
  #local Z = -9 + 60*rand(R);
  #if (abs(X) > 2.6 + 3*rand(R))
    object { Fir scale 0.8 + 1.1*rand(R) rotate 360*rand(R)*y translate <X, Land(X, Z) - 0.05, Z> }
  #end
#end

// The river that the fog comes from.
#declare Bed = function(z) { 0.9*sin(0.23*z) }
sphere_sweep {
  b_spline 14
  #for (K, 0, 13) #local Z = -20 + 6*K; <Bed(Z), -0.42 + 0.02*max(0, Z), Z>, 0.75 #end
  tolerance 0.0001
  scale <1, 0.7, 1>
  pigment { rgb <0.05, 0.08, 0.10> }
  finish { reflection { 0.1, 0.7 } conserve_energy diffuse 0.2 }
  normal { waves 0.04 scale 0.4 }
}

// A hut with a light in its window.
union {
  box { <-0.7, 0, -0.5>, <0.7, 0.8, 0.5> pigment { rgb <0.28, 0.18, 0.10> } }
  prism { linear_sweep linear_spline -0.6, 0.6, 4, <-0.85, 0.7>, <0.85, 0.7>, <0, 1.5>, <-0.85, 0.7> rotate -90*x pigment { rgb <0.12, 0.08, 0.07> } }
  box { <-0.2, 0.3, -0.51>, <0.2, 0.6, -0.5> pigment { rgb <1, 0.7, 0.3> } finish { emission 1.2 } }
  rotate -25*y translate <3.1, Land(3.1, -1) - 0.05, -1>
}

// Thick fog on the floor, uneven; thin haze far and wide.
fog { fog_type 2 distance 7 fog_offset 0.2 fog_alt 0.55 rgb <0.84, 0.75, 0.68>
  turbulence <0.5, 0.2, 0.5> turb_depth 0.55 octaves 4 omega 0.55 }
fog { distance 100 rgbt <0.90, 0.68, 0.50, 0.30> }
