#version 3.7;
#declare A = sqrt(-1);
#declare B = A + 1;
#declare C = Zork;
#if (1 < ) #declare D = 1; #end
#declare E = B + C;
#declare F = <1, 2;
#debug concat("reached ", str(1, 0, 0), "\n")
