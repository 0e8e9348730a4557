#version 3.7;
cylinder { y, y, 0.5 }
