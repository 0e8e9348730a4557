#version 3.7;
#declare Four = t;
