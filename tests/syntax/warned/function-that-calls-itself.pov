#version 3.7;
global_settings { assumed_gamma 1 }
#declare Factorial = function (n) { select(n, 0, 1, n*Factorial(n - 1)) };
sphere { 0, 1 }
