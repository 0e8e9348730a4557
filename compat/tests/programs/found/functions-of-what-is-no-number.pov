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
// Between two numbers that are known it compares with nothing.
#declare L = function { N < 1 } F(L(0, 0, 0)) #declare M1 = function { 1 < N } F(M1(0, 0, 0))
#declare O = function { N > 1 } F(O(0, 0, 0)) #declare Q = function { 1 > N } F(Q(0, 0, 0))
#declare R = function { N >= N } F(R(0, 0, 0)) #declare T = function { N != N } F(T(0, 0, 0))
