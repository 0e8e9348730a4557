#version 3.7;
#debug "\u12"
