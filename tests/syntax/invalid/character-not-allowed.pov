#version 3.7;
#declare Größe = 2;
#declare Other = 3;
