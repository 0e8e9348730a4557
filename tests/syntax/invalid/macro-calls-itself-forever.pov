#version 3.7;
#macro Forever(N)
  Forever(N + 1)
#end
Forever(0)
