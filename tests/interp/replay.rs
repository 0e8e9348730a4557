//! What is compiled on the way gives what its tokens gave: each row is a body of a loop with five turns,
//! the first of which read it and the last of which run what it was compiled to.

use super::probe;

/// Setup, body, and what is printed turn by turn; a single answer holds for all.
fn turns(table: &[(&str, &str, &str)]) {
    let rows: Vec<(String, String)> = table
        .iter()
        .map(|(setup, body, printed)| {
            let all = if printed.contains('|') { printed.replace('|', " ") } else { [*printed; 5].join(" ") };
            (format!("{setup} #for (I, 1, 5) {body} #end"), all)
        })
        .collect();
    let rows: Vec<(&str, &str)> = rows.iter().map(|(scene, printed)| (&**scene, &**printed)).collect();
    probe(&rows);
}

#[test]
fn macros_in_expressions() {
    turns(&[
        ("#macro M(A,B) A*B+1 #end", "#local Q=M(2,3)*2; F(Q)", "8"),
        ("#macro M(A,B) A*B+1 #end", "#local Q=M(I,M(2,I)); F(Q)", "4|11|22|37|56"),
        ("#macro M(A) -A #end", "#local Q=2*M(3)-M(1)*2; F(Q)", "-4"),
        ("#macro G(X_) X_*X_ #end #macro H(Y_) G(Y_+1)-G(Y_) #end", "#local Q=H(3); F(Q)", "7"),
        ("#macro L(A) #local Q=A*2; #local Q=Q+1; (Q+A) #end", "#local W=L(4); F(W)", "13"),
        ("#macro R(A) #local A=A+1; A #end #declare Q=1;", "#local W=R(Q); F(W) F(Q)", "2 2|3 3|4 4|5 5|6 6"),
        ("#macro In() Z_*2 #end #macro Out(Z_) In()+1 #end", "#local W=Out(5); F(W)", "11"),
        ("#macro M() 1 #end", "#local W=M(); F(W) #if (I=3) #macro M() 2 #end #end", "1|1|1|2|2"),
        ("#macro M(C) C*2 #end", "#local W=M(<1,2,3>); V(W) #local W=M(2); F(W)", "2,4,6 4"),
        ("#macro M(C) C #end", "#local W=<M(1),M(2)+1,M(I)>; V(W)", "1,3,1|1,3,2|1,3,3|1,3,4|1,3,5"),
        ("#macro M(C) C; #end", "#local W=M(1) F(W)", "1"),
        ("#macro M(C) #local D=C; #end", "#local W=2*(3 M(1)); F(W)", "6"),
        ("#declare R=seed(3); #macro M() rand(R)*0+I #end", "#local W=M()+M(); F(W)", "2|4|6|8|10"),
        ("#macro M(C) C.x #end", "#local W=M(<I,2,3>)+1; F(W)", "2|3|4|5|6"),
        (
            "#macro M(C) C #end",
            "#local W=M(rgb <0.1,0.2,0.3>)+0; V5(W)",
            "0.100000001,0.200000003,0.300000012,0,0",
        ),
    ]);
}

#[test]
fn declarations() {
    turns(&[
        ("#declare A=1;", "#declare A=A*2; F(A)", "2|4|8|16|32"),
        (
            "#declare X_=1;",
            "#local Y_=X_*2; V(Y_) #if (I=3) #declare X_=<1,2,3>; #end",
            "2,0,0|2,0,0|2,0,0|2,4,6|2,4,6",
        ),
        ("#declare A=array[3]{1,2,3}", "#declare A[mod(I,3)]=A[0]+I; F(A[mod(I,3)])", "2|3|4|8|9"),
        (
            "#declare A=array[2][2]",
            "#declare K=min(max(I-2,0),1); #declare A[1][K]=I; F(A[1][K])",
            "1|2|3|4|5",
        ),
        (
            "#declare A=array[1]{1} #declare B=A;",
            "#declare A[0]=A[0]+1; F(A[0]) F(B[0])",
            "2 1|3 1|4 1|5 1|6 1",
        ),
        ("#declare C=array[2]{rgb 0.5, rgb 0.25}", "#declare C[1]=C[0]*0.5; V5(C[1])", "0.25,0.25,0.25,0,0"),
        ("", "#local A=I; F(A) #undef A", "1|2|3|4|5"),
        ("#macro M(A) #declare A=A+1; #end #declare Q=array[1]{1}", "M(Q[0]) F(Q[0])", "2|3|4|5|6"),
        ("#macro M() #local A=5; #local B=A+1; F(B) #end #declare A=1;", "M() F(A)", "6 1"),
        ("#declare A=1;", "#local B=A;; F(B)", "1"),
    ]);
}

#[test]
fn choices_and_loops_in_loops() {
    turns(&[
        ("", "#if (I<3) F(1) #elseif (I<5) F(2) #else F(3) #end", "1|1|2|2|3"),
        ("", "#if (I=2 | I=4) #else F(I) #end", "1|3|5"),
        (
            "#declare N=0;",
            "#declare K=0; #while (K<I) #declare K=K+1; #declare N=N+K; #end F(N)",
            "1|4|10|20|35",
        ),
        ("", "#local K=0; #while (1) #local K=K+1; #if (K>I) #break #end #end F(K)", "2|3|4|5|6"),
        ("", "#for (K,5,1,-2) #if (K=I) F(K) #end #end", "1|3|5"),
        ("", "#switch (I) #case (2) F(20) #break #range (3,4) F(30) #else F(0) #end", "0|20|30 0|30 0|0"),
        ("#declare L=array[2]{0,9}", "#for (K,0,1) F(L[K]) #end", "0 9"),
    ]);
}

#[test]
fn strings() {
    turns(&[
        (
            "",
            "#local T=concat(\"n\",str(I,0,2),chr(65)); S(T)",
            "[n1.00A]|[n2.00A]|[n3.00A]|[n4.00A]|[n5.00A]",
        ),
        ("", "#local T=concat(\"a\",\"b\") F(strlen(concat(T,str(I,3,0))))", "5"),
        ("#declare T=\"x\";", "#declare T=concat(T,T); F(strlen(T))", "2|4|8|16|32"),
        ("", "#local N=strcmp(str(I,0,0),\"3\")*0+val(str(I/4,0,3)); F(N)", "0.25|0.5|0.75|1|1.25"),
        ("", "#local T=str(I/7,0,-1); S(T)", "[0.142857]|[0.285714]|[0.428571]|[0.571429]|[0.714286]"),
        ("", "#local T=str(-I/1000,0,2); S(T)", "[-0.00]|[-0.00]|[-0.00]|[-0.00]|[-0.01]"),
    ]);
}
