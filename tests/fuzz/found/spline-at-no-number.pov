// A spline asked at what is no number.
#declare N = 1e400 - 1e400;
#declare S = spline { cubic_spline 0, x, 1, y, 2, z, 3, x }
#declare T = spline { cubic_spline 0, x, 1, y, 2, z }
#declare V = S(N) + T(N) + S(N, natural_spline) + S(N, quadratic_spline) + S(N, linear_spline);
sphere { V, 1 }
