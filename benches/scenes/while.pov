// A loop that makes a hundred thousand spheres, each with a place and a colour of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -30> look_at 0 }
light_source { <-50, 80, -60>, 1 }

#declare Seed = seed(7);
#declare I = 0;
#while (I < 100000)
  sphere {
    <20 * rand(Seed) - 10, 8 * sin(I / 500) + rand(Seed), 10 * rand(Seed)>, 0.02 + 0.05 * rand(Seed)
    pigment { color rgb <rand(Seed), 0.5 + 0.5 * sin(I / 9000), rand(Seed)> }
  }
  #declare I = I + 1;
#end
