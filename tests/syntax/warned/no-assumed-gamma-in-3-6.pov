#version 3.6;
sphere { 0, 1 }
