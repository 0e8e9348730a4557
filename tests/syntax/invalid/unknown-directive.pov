#version 3.7;
#decalre A = 3;
