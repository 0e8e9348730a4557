use super::probe;

#[test]
fn arrays() {
    probe(&[
        ("#declare A=array[2][2]{{1,2}{3,4}} F(A[1][0])", "3"),
        ("#declare A=array[3]{1,2}", "E"),
        ("#declare A=array[2]{1,2,3}", "E"),
        (r#"#declare A=array[2]{1,"a"}"#, "E"),
        ("#declare A=array[2]{<1,2,3>,<1,2>}", "E"),
        ("#declare A=array{1,2}", "E"),
        ("#declare A=array[3]{1,2,3} F(A[1.9]) F(A[1-1e-11]) F(A[-1e-11])", "2 2 1"),
        ("#declare A=array[3]{1,2,3} F(A[3])", "E"),
        ("#declare A=array[3]{1,2,3} F(A[-1])", "E"),
        ("#declare A=array[3]; F(A[0])", "E"),
        ("#declare A=array[2][2]; #declare A[1]=3;", "E"),
        ("#declare A=array[0];", "E"),
        ("#declare A=array[2]{1,2} #declare B=A; #declare B[0]=9; F(A[0]) F(B[0])", "1 9"),
        ("#declare A=array[2]; #declare A[0]=array[2]{5,6} F(A[0][1])", "6"),
        ("#declare A=array[3][4]; F(dimensions(A)) F(dimension_size(A,2)) F(dimension_size(A,3))", "2 4 0"),
        ("#macro M() 7 #end #declare A=array[2]{(M()),0+M()} F(A[0]+A[1])", "14"),
        ("#declare A=array[2]{1,2} #undef A[0] #ifdef(A[0]) F(1) #else F(0) #end", "0"),
        ("#declare A=array[3]{1 2 3} F(A[2])", "3"),
        ("#declare A=3; #declare A[0]=1;", "E"),
    ]);
}
