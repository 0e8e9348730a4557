#declare K1 = spline { quadratic_spline -1.7, <4.3, 1.1, 5.7>, -1.1, <1.9, 8.3, 6.1>, -0.3, <3.3, 8.9, 0.7>, 2.9, <1.3, 5.1, 4.7> }
#for (I, -1.9, 3.1, 0.13)
V(K1(I)) V(K1(I, linear_spline)) V(K1(I, cubic_spline)) V(K1(I, natural_spline))
#end
