// Each element is rounded once after its cofactor: the last digits show it, blown up.
#macro Blown(W) F((W).x * pow(2, 50)) F((W).y * pow(2, 50)) F((W).z * pow(2, 50)) #end
#macro Unit(G) Blown(G(0, 0, 0)) Blown(G(1, 0, 0)) Blown(G(0, 1, 0)) Blown(G(0, 0, 1)) #end
#declare A = function { transform { matrix <1, 2, 0, 0, 1, 3, 2, 0, 1, 4, 5, 6> inverse } }
Unit(A)
#declare B = function { transform { matrix <1.1, 2, 0.3, 0, 1.7, 3, 2, 0.9, 1, 0, 0, 0> inverse } }
Unit(B)
