#version 3.7;
/* outer /* inner */
#declare A = 1;
