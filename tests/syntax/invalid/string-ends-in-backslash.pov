#version 3.7;
#declare Text = "one \
two";
