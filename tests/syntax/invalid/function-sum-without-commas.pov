#version 3.7;
#declare Series = function (x) { sum(i 0 x i) };
