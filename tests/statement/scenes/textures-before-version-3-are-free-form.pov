#version 2.0;
sphere { <0 0 0> 1
  texture { 0.05 bozo color_map { [0 1 color red 1 color blue 1] } bumps 0.8 turbulence 2 frequency 3 scale <2 2 2> ambient 0.3 }
}
sphere { <3 0 0> 1
  texture { ripples 0.8 color red 1 color green 1 phong 1 phong_size 80 }
}
