#version 3.7;
global_settings { assumed_gamma 1 }
global_settings {
  adc_bailout 0.01 ambient_light rgb 0.5 max_trace_level 12 number_of_waves 4 noise_generator 3 mm_per_unit 2
  irid_wavelength rgb <0.7, 0.5, 0.4>
  subsurface { samples 20, 10 radiosity on }
  radiosity { count 100, 2000 nearest_count 8, 2 error_bound 0.5 maximum_reuse 0.02 normal on }
  photons { spacing 0.1 gather 10, 50 radius 0.5, 2 media 10, 3 save_file "a.ph" }
}
sphere { 0, 1 }
