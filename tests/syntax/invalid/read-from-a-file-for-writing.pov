#version 3.7;
#fopen Log "/dev/null" append
#read (Log, A)
