#version 3.7;
#declare Series = function (x) { sum(i, 0, 1e12, x/i) };
