#version 3.7;
#include "roots.inc"
#declare A = Outer(-4);
