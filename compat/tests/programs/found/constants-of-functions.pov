// Constants are put together, and powers made products, in the first argument of a call only, and not in parentheses.
#declare P = function(b) { pow(b, 6) } #declare Q = function(b) { pow(b, (6)) } #declare R = function(b) { select(-1, pow(b, 6), 0) }
#declare S = function(b) { abs(pow(b, 6)) } #declare T = function(b) { min(1e30, pow(b, 6)) } #declare U = function(b) { sum(i, 1, 2, pow(b, 6)) }
#declare A = 0.77; #declare B1 = function(b) { pow(pow(pi, 8), 3) } #declare B2 = function(b) { pow((A), 6) } #declare B3 = function(b) { pow(A, 6) }
#declare E1 = function(b) { 0.3 / 7 * b } #declare E2 = function(b) { min(1e30, 0.3 / 7 * b) } #declare E3 = function(b) { b / (7) }
#declare E4 = function(b) { (12) / 2 * 3 + b } #declare E5 = function(b) { min(1e9, (12) / 2 * 3 + b) } #declare E6 = function(b) { pow(1.7, 0.3 / 7 * b) }
#declare E7 = function(b) { b - 8 / 3 + A } #declare E8 = function(b) { b - 2 * 3 - A } #declare E9 = function(b) { b - 2 * 3 - 2 * 3 - 5 + 1 }
#declare G1 = function(b) { min(0, b) } #declare G2 = function(b) { min(b, 0) } #declare G3 = function(b) { max(0, b) } #declare G4 = function(b) { int(b) }
#declare G5 = function(b) { div(b, 3) } #declare Z = pigment { gradient x color_map { [0 rgb <.1, .2, .3>] [1 rgb <.7, .4, .9>] } }
#declare H = function { pigment { Z } } #declare H1 = function(b) { H(b, 0, 0).hf }
#for (I, -8.133, 7, 1.07)
F(P(I)) F(Q(I)) F(R(I)) F(S(I)) F(T(I)) F(U(I)) F(E1(I)) F(E2(I)) F(E3(I)) F(E4(I)) F(E5(I)) F(E6(I)) F(E7(I)) F(E8(I)) F(E9(I)) F(H1(I / 17))
#end
F(B1(0)) F(B2(0)) F(B3(0)) F(G1(-0)) F(G2(-0)) F(G3(-0)) F(G4(-0.5)) F(G5(-1))
