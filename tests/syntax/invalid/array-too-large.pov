#version 3.7;
#declare A = array[100000][100000];
