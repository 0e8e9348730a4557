#version 3.7;
#fopen Data "data.txt" read
#fopen Data "data.txt" read
