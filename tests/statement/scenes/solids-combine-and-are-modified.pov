#version 3.7;
global_settings { assumed_gamma 1 }
#declare Ball = sphere { 0, 1 }
difference {
  union { object { Ball translate x } Ball split_union off }
  cylinder { -y, y, 0.5 }
  hollow double_illuminate off no_shadow no_image off inverse
  bounded_by { box { -3, 3 } }
  clipped_by { bounded_by }
  photons { target 0.5 reflection on refraction off collect off }
  radiosity { importance 0.5 }
}
Ball
torus { Ball scale 2 }
