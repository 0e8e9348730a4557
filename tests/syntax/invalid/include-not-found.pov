#version 3.7;
#include "colours.inc"
