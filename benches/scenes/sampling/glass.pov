// Glass balls over stripes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <5, 8, -6> rgb 1 }

background { rgb <0.4, 0.6, 0.9> }
plane { y, 0 pigment { gradient x color_map { [0.5 rgb 0.9] [0.5 rgb <0.6, 0.1, 0.1>] } scale 0.6 } }
#for (I, -1, 1)
  sphere {
    <1.5*I, 0.8, 0.4*I*I>, 0.75
    pigment { rgbf <0.97, 1, 0.98, 0.95> }
    finish { specular 0.8 roughness 0.002 reflection { 0.05, 0.9 fresnel } conserve_energy }
    interior { ior 1.5 }
  }
#end
