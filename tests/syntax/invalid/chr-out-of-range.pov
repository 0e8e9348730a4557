#version 3.7;
#declare A = chr(70000);
