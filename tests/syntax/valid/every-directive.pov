#version 3.7;
// Directives and macro calls stand between any two tokens.
#macro Two() 2 #end
#declare A = array[3] {1, Two(), 3}
#for (I, 0, #if (1) dimension_size(A, 1) #else 0 #end - 1)
  #debug concat(str(A[I], 0, 0), " ")
#end
#local I = 0;
#while (I < 3)
  #switch (I)
    #case (0) #debug "zero " #break
    #range (1, 1) #debug "one " #break
    #else #debug "more "
  #end
  #declare I = I + 1;
#end
#ifdef (Zork) #error "no" #elseif (defined(A)) #debug "defined\n" #end
#undef A
#ifndef (A) #debug "gone\n" #end
#include "roots.inc"
#debug concat(str(Outer(9), 0, 1), "\n")
