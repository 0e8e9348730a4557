#version 3.7;
#debug "C:\qdir"
