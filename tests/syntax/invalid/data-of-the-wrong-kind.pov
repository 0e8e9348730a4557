#version 3.7;
#fopen Data "bad-data.txt" read
#read (Data, A, B)
