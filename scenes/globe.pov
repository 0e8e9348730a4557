// Pictures of any shape, wrapped on a globe without distortion: `max_extent` tells how wide and high each is.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.1 diffuse 0.8 } }

camera { location <0, 1.2, -6> look_at 0 right x*image_width/image_height angle 38 }
light_source { <-20, 30, -40> rgb 1 }
background { rgb <0.10, 0.13, 0.20> }

// A texture with Picture around the direction given by Azimuth (0 … 360 degrees, from the camera's side to
// the right) and Elevation (-90 … 90), Height degrees high on a sphere around the origin.
#macro Wrapped(Picture, Azimuth, Elevation, Height)
  #local Size = max_extent(Picture);
  #local Width = Height*Size.x/Size.y;
  texture {
    pigment {
      Picture
      // Its middle goes to where the camera looks: a quarter before the end of the turn, on the equator.
      translate <-0.5, -0.5, 0>
      scale <Width/360, Height/180, 1>
      translate <0.75, 0.5, 0>
      warp { spherical }
      rotate Elevation*x
      rotate -Azimuth*y
    }
  }
#end

// From a file, from a function of numbers and from one of colours: wide, square and tall.
#declare Wide = pigment { image_map { png "target.png" once interpolate 2 } }
#declare Square = pigment {
  image_map { function 64, 64 { abs(sin(20*sqrt((x-0.5)*(x-0.5) + (y-0.5)*(y-0.5)))) } once interpolate 2 }
}
#declare Tall = pigment {
  image_map {
    function 40, 120 {
      pigment {
        checker rgb <0.9, 0.5, 0.1> rgb <0.3, 0.1, 0.4>
        scale <1/4, 1/12, 1>
      }
    }
    once
  }
}

sphere {
  0, 1.4
  texture { pigment { rgb <0.25, 0.45, 0.60> } }
  Wrapped(Wide, 0, 5, 40)
  Wrapped(Wide, 0, -55, 40)
  Wrapped(Square, 55, 20, 30)
  Wrapped(Tall, 310, 25, 70)
  Wrapped(Wide, 180, 75, 30)
}

plane { y, -1.4 pigment { checker rgb 0.5 rgb 0.6 } }
