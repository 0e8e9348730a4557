#version 3.7;
// What an arm opens another arm may close; here with parentheses and vectors, too.
#declare Deep = 1;
#declare A = (#if (Deep) (1 + #else (2 + #end 3));
#declare B = (<1, 2, #if (Deep) 3> #else 4> #end * 2);
#debug concat(str(A, 0, 0), " ", vstr(3, B, ",", 0, 0), "\n")
