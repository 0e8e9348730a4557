use super::probe;

#[test]
fn arguments_by_reference_and_by_value() {
    let increment = "#macro Inc(a) #declare a=a+1; #end ";
    probe(&[
        (
            &format!("{increment}#declare Q=5; Inc(Q) F(Q) Inc(Q+0) F(Q) Inc((Q)) F(Q) Inc(+Q) F(Q)"),
            "6 6 6 6",
        ),
        (&format!("{increment}#declare Q=array[3]{{1,2,3}} Inc(Q[1]) F(Q[1])"), "3"),
        ("#macro C(a) #local a=9; #end #declare Q=1; C(Q) F(Q)", "9"),
        ("#declare i=0; #macro N() #declare i=i+1; i #end #macro M(a,b) F(a) F(b) #end M(N(),N())", "2 2"),
        ("#macro M(a) #undef a #end #declare Q=1; M(Q) F(Q)", "1"),
        ("#macro M(a) #declare a[0]=7; #end #declare Q=array[1]{1} M(Q) F(Q[0])", "7"),
        // The macro may end with the declaration.
        ("#macro M(a) #declare a=\"new\" #end #declare T=\"old\" M(T) S(T)", "[new]"),
        ("#macro M(s) S(s) #end #declare T=\"x\" M(T) M(\"y\")", "[x] [y]"),
    ]);
}

#[test]
fn results_are_the_tokens_of_the_body() {
    probe(&[
        ("#macro A(a,b) a+b #end F(A(1,2)*2) #macro B(a,b) (a+b) #end F(B(1,2)*2)", "5 6"),
        ("#macro P() +2 #end F((1 P()))", "3"),
        ("#macro P() +2 #end #declare B=1 P();", "E"),
        ("#macro M() #local q=<1,2,3>; q #end F(2*M().y)", "4"),
        ("#macro M(n) #if(n) 1 #else 2 #end #end F((M(1)))", "1"),
        ("#macro M(n) #if(n) 1 #else 2 #end #end #declare A=M(1);", "E"),
        ("#macro M() 7 #end #declare A=M(); F(A) F(M())", "7 7"),
        ("#macro M() #local q=<1,2,3>; q; #end #macro N() #local A=M() V(A) #end N()", "1,2,3"),
        ("#macro M(n) #if(n) 7; #else 8; #end #end #macro N() #local A=M(1) F(A) #end N()", "7"),
        ("#macro M() #local A=5; A #end #macro N() #local A=M(); F(A) #end N()", "5"),
        ("#macro V3(a) <a,a,a> #end V(V3(2))", "2,2,2"),
        ("#macro A() #macro B() F(3) #end B() #end A() B()", "3 3"),
        ("#macro M() 1 #end #macro M() 2 #end F(M())", "2"),
        (
            "#macro Fact(n) #if(n<=1) #local r=1; #else #local r=n*Fact(n-1); #end r #end F(Fact(10))",
            "3628800",
        ),
    ]);
}

#[test]
fn wrong_calls() {
    let two = "#macro M(a,b) F(a) #end ";
    probe(&[
        (&format!("{two}M(1)"), "E"),
        (&format!("{two}M(1,2,3)"), "E"),
        (&format!("{two}M(1 2) M(1,2,)"), "1 1"),
        ("#macro M(a) F(1) #end M(Zork)", "E"),
        ("#macro M(a) F(1) #end M 1", "E"),
        ("#macro M F(1) #end", "E"),
        ("#macro M(sphere) #end", "E"),
        ("#macro sphere() #end", "E"),
        ("#macro W() #if(1) #end", "E"),
        ("#macro M() M() #end M()", "E"),
    ]);
}
