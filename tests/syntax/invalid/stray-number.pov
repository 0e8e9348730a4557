#version 3.7;
42
