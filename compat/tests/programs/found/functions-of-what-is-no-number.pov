// In functions what is no number is greater than anything, and `min` and `max` take what does not compare.
#declare N = 1e400 - 1e400;
#macro P(G) F(G(N, 1)) F(G(1, N)) F(G(N, N)) F(G(1, 1)) F(G(1, 2)) F(G(2, 1)) #end
#declare A = function (x, y) { x < y } P(A)
#declare B = function (x, y) { x <= y } P(B)
#declare C1 = function (x, y) { x > y } P(C1)
#declare D = function (x, y) { x >= y } P(D)
#declare E = function (x, y) { x = y } P(E)
#declare G1 = function (x, y) { x != y } P(G1)
#declare H = function (x, y) { min(x, y) } P(H)
#declare I = function (x, y) { max(x, y) } P(I)
#declare J = function (x, y) { max(x, y, 2) + min(x, 3, y) } P(J)
#declare K = function (x, y) { (N > x) + 2 * (y >= N) } P(K)
