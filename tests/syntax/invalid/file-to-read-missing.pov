#version 3.7;
#fopen Data "no-such-file.txt" read
