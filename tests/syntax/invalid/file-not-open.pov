#version 3.7;
#read (Data, A)
