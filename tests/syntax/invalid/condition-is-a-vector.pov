#version 3.7;
#if (<1, 2, 3>)
#end
