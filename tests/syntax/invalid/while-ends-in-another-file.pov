#version 3.7;
#include "starts-while.inc"
#end
