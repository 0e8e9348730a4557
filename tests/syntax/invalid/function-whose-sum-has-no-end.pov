#version 3.7;
#declare Series = function (n) { sum(i, 0, n, 1/(i+1)) };
#debug str(Series(1e300), 0, 0)
