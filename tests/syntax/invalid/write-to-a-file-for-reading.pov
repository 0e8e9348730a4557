#version 3.7;
#fopen Data "data.txt" read
#write (Data, 1)
