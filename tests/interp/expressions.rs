use super::{probe, probe_repeated};

#[test]
fn operators() {
    probe_repeated(&[
        ("F(1+2*3) F(8/2/2) F(2*-3) F(!0+1) F(1--1)", "7 2 -6 2 2"),
        ("F((1|0&0)) F((0&0|1)) F((1<2<3)) F((3>2>1))", "0 1 1 0"),
        ("F(1<2)", "E"),
        ("F(sin(1<2))", "0.841470984808"),
        ("F(max(1<2,0))", "E"),
        ("F((1=1+1e-11)) F((1=1+1e-9)) F((1<1+1e-11)) F((1<=1-1e-11)) F(!1e-11)", "1 0 1 1 1"),
        ("V((<1,2,3> = <1,5,3>))", "1,0,1"),
        ("V((<1,2,3> < <2,2,2>))", "1,0,0"),
        ("F((0?2:3)) F((1?0?5:6:7))", "3 6"),
        ("F((<1,2>?1:2))", "E"),
        (r#"F(("a"="b")) F(("a"<"b"))"#, "0 1"),
        ("V((<1,2,3>=<1,2,3>))", "E"),
        ("F(-(<1,2,3>.x))", "-1"),
        ("#declare W=<4,5,6>; F(-W.x)", "-4"),
        ("F(1==1)", "E"),
    ]);
}

#[test]
fn sizes() {
    probe_repeated(&[
        ("V5(<1,2>+<1,1,1,1,1>)", "2,3,1,1,1"),
        ("V5(1+<1,1,1,1,1>)", "2,2,2,2,2"),
        ("V(<1,2,3>/<2,0,1>)", "0.5,inf,3 W"),
        ("F(<1,2,3,4,5>.gray) F(<1,2,3,4>.t)", "1.817 4"),
        ("F(<1,2,3>.t)", "E"),
        ("V(<1>)", "E"),
        ("V5(<1,2,3,4,5,6>)", "E"),
        ("V(<x,1,2>)", "E"),
        ("V(<1 2 3>)", "1,2,3"),
        ("V(<1,2,3,>)", "1,2,3"),
        ("V2(<1 -1 0>)", "0,0"),
        ("F(x.x.x)", "E"),
        ("F(<1,2,3>.grey)", "E"),
        ("V(x+2*y) V2(u+v) F(1*t.t)", "1,2,0 1,1 1"),
        ("F(t.t)", "E"),
        ("#declare A=t;", "E"),
        ("F(vlength(2))", "3.464101615138"),
        ("F(sin(x))", "E"),
    ]);
}

#[test]
fn colors() {
    probe_repeated(&[
        ("V5(rgbt 0.5)", "0.5,0.5,0.5,0,0.5"),
        ("V5(rgbt <1,2,3,4>)", "1,2,3,0,4"),
        ("V5(rgb <1,2>)", "1,2,0,0,0"),
        ("V5(red 1 green 2 filter 4)", "1,2,0,4,0"),
        ("V5(2*rgb 1)", "E"),
        ("#declare C=rgb 0.1; S(str(C.red,0,20))", "[0.10000000149011611938]"),
        ("V5(rgb <1,2,3>*0.5+0.1)", "0.600000024,1.100000024,1.600000024,0,0"),
        ("V5(rgb 1>0?2:3)", "2,2,2,0,0"),
        ("V5(color rgb 1) V5(colour red 1)", "1,1,1,0,0 1,0,0,0,0"),
        ("#declare C=rgb <1,2,3>; V5(C*0.5+<1,2,3>)", "1.5,3,4.5,0,0"),
        ("V5(rgb <1,2,3,4>)", "1,2,3,4,0 W"),
        ("V5(srgb <1,0.5,0.02>)", "1,0.214041144,0.001547988,0,0"),
        ("#declare C=color <1,2,3>; V5(C)", "1,2,3,0,0"),
        ("V5(rgb 1 transmit 0.5)", "1,1,1,0,0.5"),
    ]);
}

#[test]
fn float_functions() {
    probe_repeated(&[
        ("F(mod(-7,3)) F(div(-7,2)) F(floor(-2.5)) F(int(-2.7))", "-1 -3 -3 -2"),
        ("F(5/0)", "inf W"),
        ("F(0/0)", "inf W"),
        ("F(mod(5,0)) F(div(5,0))", "-nan -2147483648"),
        ("F(sqrt(-1))", "E"),
        ("F(ln(0))", "E"),
        ("F(pow(0,0))", "E"),
        ("F(atan2(0,0))", "E"),
        ("F(asin(2))", "1.570796326795 W"),
        ("F(select(0,10,20)) F(select(1e-12,10,20,30))", "20 30"),
        ("F(max(1,5,3)) F(min(4,2)) F(max(7))", "5 2 7"),
        ("F(min(1 2))", "E"),
        ("F(bitwise_and(6,3)) F(bitwise_or(6,3)) F(bitwise_xor(6,3))", "2 7 5"),
        ("F(degrees(pi)) F(radians(180)) F(pow(2,10)) F(pow(0,-1))", "180 3.14159265359 1024 inf"),
        ("F(clock) F(clock_on) F(true) F(off)", "0 0 1 0"),
        ("F(sqr(2))", "E"),
        ("F(abs(-3)) F(ceil(1.2)) F(log(100)) F(exp(0)) F(vdot(x,<2,3,4>))", "3 2 2 1 2"),
    ]);
}

#[test]
fn vector_functions() {
    probe_repeated(&[
        ("V(vrotate(<1,2,3>,<10,20,30>))", "1.067425379,2.289059483,2.760581414"),
        ("V(vaxis_rotate(<1,2,3>,<1,2,2>,37))", "1.44595768,1.888890321,2.888130839"),
        ("V(vcross(x,y)) V(vnormalize(<3,0,4>))", "0,0,1 0.6,0,0.8"),
        ("V(vnormalize(0))", "0,0,0 P"),
    ]);
}

#[test]
fn random_numbers_are_the_same_bit_for_bit() {
    probe(&[
        (
            "#declare R=seed(0); F(R) F(rand(R)) F(rand(R)) F(rand(R))",
            "0 0.000002874294 0.466563684509 0.249070228834",
        ),
        ("#declare R=seed(-1); F(rand(R))", "0.578012873553"),
        ("F(rand(seed(1))) F(rand(seed(3000000000)))", "0.421992875268 0.500002874411"),
        ("F(rand(3))", "E"),
    ]);
}

#[test]
fn splines() {
    let k = "0,<0,0,0> 1,<1,2,3> 3,<5,0,0> 4,<1,1,1>";
    probe(&[
        (&format!("#declare L=spline{{linear_spline {k}}} V(L(2)) V(L(-1)) V(L(9))"), "3,1,1.5 0,0,0 1,1,1"),
        (&format!("#declare L=spline{{{k}}} V(L(2,natural_spline))"), "3.9375,1.1875,1.875"),
        ("#declare L=spline{linear_spline 0,<0,0,0> 1,<1,1,1> 1,<5,5,5>} F(L(1).x)", "1"),
        ("#declare L=spline{linear_spline 0,<0,0,0> 1,<1,1,1> 2,<2,2,2> 1,<5,5,5>} F(L(1).x)", "5"),
        ("#declare L=spline{linear_spline 0,1 1,5} V2(L(.5))", "3,3"),
        ("#declare L=spline{linear_spline}", "E"),
        ("#declare L=spline{0,rgb 1}", "E"),
        ("#declare L=spline{0,x} #declare M=spline{L 1,y} V(M(1)) #declare N=M; V(N(0))", "0,1,0 1,0,0"),
    ]);
}

#[test]
fn compiled_expressions_give_what_the_others_give() {
    probe(&[
        ("#for(I,1,4) F(1/(I-3)) #end", "-0.5 -1 inf 1 W"),
        (
            "#macro M(a) F(vlength(a)) V(a*2) #end M(1) M(2) M(3) M(x) M(<3,4>) M(4)",
            "1.732050807569 2,0,0 3.464101615138 4,0,0 5.196152422707 6,0,0 1 2,0,0 5 6,8,0 6.928203230276 8,0,0",
        ),
        (
            "#declare R=seed(0); #declare A=R; #for(I,1,4) F(rand(A)/(2-I)) #end",
            "0.000002874294 inf -0.249070228834 -0.482938021068 W",
        ),
        ("#declare A=array[5]{1,2,3,4,5} #for(I,0,4) F(A[I]*2+A[mod(I+1,5)]) #end", "4 7 10 13 11"),
        ("#declare A=array[2][2]{{1,2}{3,4}} #for(I,0,1) #for(J,0,1) F(A[I][J]) #end #end", "1 2 3 4"),
        ("#declare A=array[3]{1,2,3} #for(I,0,3) F(A[I]) #end", "1 2 3 E"),
        ("#macro P() +10 #end #for(I,1,4) F((I P())) #end", "11 12 13 14"),
        ("#for(I,1,4) F((I #if(I=3) *100 #end)) #end", "1 2 300 4"),
        ("#for(I,1,4) F((I>2?I*10:-I)) #end", "-1 -2 30 40"),
        ("#for(I,1,4) V(<I,2*I,-I>*<1,1,2>+x) #end", "2,2,-2 3,4,-4 4,6,-6 5,8,-8"),
        ("#for(I,1,4) V(2*<I,1>.y*z/2) #end", "0,0,1 0,0,1 0,0,1 0,0,1"),
        ("#for(I,-1,2) F(select(I,10,20,30)) F(select(I,10,20)) #end", "10 10 20 20 30 20 30 20"),
        ("#for(I,1,3) #declare X=I; #if(I=2) #declare X=<I,I,I>; #end V(X*2) #end", "2,0,0 4,4,4 6,0,0"),
        ("#for(I,1,4) #declare deprecated \"old\" Z=I; F(Z) #end", "1 2 3 4 W"),
    ]);
}
