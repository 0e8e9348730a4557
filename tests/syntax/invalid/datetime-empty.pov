#version 3.7;
#declare A = datetime(0, "");
