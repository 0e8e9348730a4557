#version 3.7;
#declare Size = 1.2.3;
