#version 3.7;
#declare Count = function (n) { Count(n - 1) + 1 };
#debug str(Count(3), 0, 0)
