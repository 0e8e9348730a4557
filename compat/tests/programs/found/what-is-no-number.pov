// Functions, comparisons and arms with what is no number: it equals everything, and is outside of no domain.
#declare N = 1e400 - 1e400;
F(ln(N)) F(sqrt(N)) F(log(N)) F(asin(N)) F(acos(N)) F(int(N)) F(floor(N)) F(pow(N, 2)) F(atan2(N, 1)) F(mod(N, 1))
F(min(N, 1)) F(min(1, N)) F(max(N, 1)) F(max(1, N)) F(max(1, N, 2)) F(select(N, 1, 2)) F(select(N, 1, 2, 3))
F((N < 1)) F((N > 1)) F((N = 1)) F((N != 1)) F((N >= 1)) F((N <= 1)) F((N = N)) F(!N) F((N & 1)) F((N ? 1 : 2))
F((1e400 = 1e400)) F((1e400 != 1e400)) F((1e400 <= -1e400))
V(vnormalize(<N, 1, 2>)) V(vnormalize(<1e400, 1, 2>)) V(vrotate(<1, 2, 3>, <1e400, 1, 2>)) F(vlength(<N, 1, 2>))
V(vrotate(<1e400, 1, 2>, <10, 20, 30>)) V(vaxis_rotate(<1e400, 2, 3>, <1, 2, 4>, 30)) V(vaxis_rotate(<1, 2, 3>, y, 1e400))
#switch (N) #case (1) F(1) #break #range (0, 1) F(2) #break #else F(3) #end
#if (N) F(1) #else F(2) #end
#for (I, N, 1) F(I) #end
