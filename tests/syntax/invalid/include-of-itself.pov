#version 3.7;
#include "itself.inc"
