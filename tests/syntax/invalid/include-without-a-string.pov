#version 3.7;
#include colors
