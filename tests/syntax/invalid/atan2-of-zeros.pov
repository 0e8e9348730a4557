#version 3.7;
#declare Angle = atan2(0, 0);
