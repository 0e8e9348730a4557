#version 3.7;
#undef sphere
