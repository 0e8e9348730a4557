#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <0, 10, 0> rgb <1, 0.5, 0> spotlight point_at 0 radius 10 falloff 20 tightness 2 rotate z*90 }
light_source { y, rgb 1 cylinder point_at 0 }
light_source { y, rgb 1 parallel point_at x shadowless }
light_source { y, rgb 1 area_light x, z, 4, 4 adaptive 1 jitter circular orient area_illumination on scale 2 }
light_source { y, rgb 1 fade_distance 5 fade_power 2 media_interaction off media_attenuation on }
light_source { y, rgb 1 looks_like { sphere { 0, 0.1 pigment { rgb 1 } } } translate x }
light_source { y, rgb 1 projected_through { disc { 0, z, 1 } } photons { reflection on area_light } }
light_group { light_source { y, rgb 1 } sphere { 0, 1 } global_lights on translate z }
