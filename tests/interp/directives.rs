use super::{probe, probe_in};
use povista::source::Library;

#[test]
fn declarations() {
    probe(&[
        ("#declare A=3\n#declare B=4;", "E"),
        (r#"#declare A="x" #declare B=array[1] F(1)"#, "1"),
        ("#declare A=3;; F(A)", "3"),
        ("#declare A=3;;;", "E"),
        ("#declare A=1; #undef A;", "E"),
        ("#declare f=function(x){x} #declare f=function(x){2*x}", "E"),
        ("#declare f=function(x){x} #undef f #declare f=function(x){2*x}", ""),
        ("#declare f=1; #declare f=function(x){x}", "E"),
        ("#macro M() 1 #end #declare M=3;", "E"),
        ("#macro M() #local A=5; #declare A=7; F(A) #end #declare A=1; M() F(A)", "7 1"),
        ("#macro I() F(L) #end #macro O() #local L=4; I() #end O()", "4"),
        ("#declare A=1+#declare B=3; B; F(A)", "4"),
        ("#declare A=1 + #if(0) 2 #else 3 #end *2;", "E"),
        ("#declare A=sin(1 #if(1) +2 #end); F(A)", "0.14112000806"),
        ("V(<1,#if(1) 2 #else 3 #end,4>)", "1,2,4"),
        (r#"#declare deprecated once "old" A=3; F(A) F(A)"#, "3 3 W"),
        ("#declare sphere=3;", "E"),
        ("#declare A=1<2;", "E"),
        ("#declare A=(1<2); F(A)", "1"),
        ("#undef Zork F(1)", "1 W"),
        ("#undef sphere", "E"),
        ("#declare A=2; #declare A=A*A+1; F(A)", "5"),
        ("#version 3.1; #declare A=3 F(A)", "3 P"),
        ("#version 3.0; #declare A=3 #debug concat(str(A,0,0),\"\\n\")", "3"),
        ("declare A=3; F(A)", "3 P"),
    ]);
}

#[test]
fn conditionals() {
    probe(&[
        ("#if(1e-11) F(1) #else F(2) #end #if(-1) F(3) #end", "2 3"),
        ("#if(1) F(1) #elseif(Undefined=2) F(2) #end", "1"),
        ("#if(0) F(1) #elseif(1) F(2) #elseif(1) F(3) #else F(4) #end", "2"),
        ("#if(0) F(1) #else F(2) #elseif(1) F(3) #end", "2 E"),
        ("#if 1 F(1) #end", "E"),
        ("#if(<1,2,3>)", "E"),
        (
            "#declare A=array[3]; #declare A[1]=5; #ifdef(A[0]) F(1) #else F(0) #end #ifdef(A[1]) F(4) #end",
            "0 4",
        ),
        ("#ifdef(sphere) F(1) #else F(0) #end #ifdef(F) F(2) #end #ifndef(Zork) F(3) #end", "0 2 3"),
        (r#"#declare A="x"; #if(A="x" & 1) F(1) #end"#, "1"),
        (
            "#if(0) #if(1) #else #end #while(1) #end #switch(1) #case(1) #end #macro M() #end F(1) #end F(2)",
            "2",
        ),
        ("#if(1) F(1)", "1 E"),
        ("#end", "E"),
        ("#else", "E"),
        ("F(defined(F)) F(defined(Zork)) F(defined(image_width))", "1 0 1"),
    ]);
}

#[test]
fn loops() {
    probe(&[
        ("#declare I=0; #while(I<3) F(I) #declare I=I+1; #end F(I)", "0 1 2 3"),
        ("#for(I,1,3) F(I) #end F(I)", "1 2 3 4"),
        ("#for(I,0,1,0.1) #end F(I) #declare N=0; #for(I,0,1,0.1) #declare N=N+1; #end F(N)", "1.1 11"),
        ("#for(I,3,1) F(I) #end F(I)", "3"),
        ("#for(I,3,1,-1) F(I) #end F(I)", "3 2 1 0"),
        ("#for(I,1,5) F(I) #declare I=I+1; #end", "1 3 5"),
        ("#for(I 1 3) F(I) #end", "1 2 3"),
        ("#for(I,1,3,0) #end", "E"),
        ("#macro M() #for(I,1,2) #end F(I) #end #declare I=77; M() F(I)", "3 77"),
        ("#for(I,1,3) #undef I #end", "E"),
        ("#for(I,1,3) #for(J,1,2) #if(J=2) #break #end F(I*10+J) #end #end", "11 21 31"),
        ("#while(1) #if(1) #break #end #end F(2)", "2"),
    ]);
}

#[test]
fn switches() {
    probe(&[
        ("#switch(2) #case(1) F(1) #break #case(2) F(2) #case(3) F(3) #break #else F(9) #end", "2 3"),
        ("#switch(1) #case(1) F(1) #else F(9) #end", "1 9"),
        ("#switch(7) #case(1) F(1) #else F(9) #end", "9"),
        ("#switch(2+1e-12) #range(1,2) F(1) #break #else F(0) #end", "0"),
        ("#switch(1+1e-11) #case(1) F(1) #break #end", "1"),
        ("#switch(1) #end", "E"),
        ("#switch(1) F(1) #case(1) F(2) #end", "1 2"),
        ("#switch(1) x #case(1) F(2) #end", "E"),
        (
            "#switch(1) #case(1) #switch(2) #case(2) F(2) #break #end F(3) #break #case(2) F(4) #end F(5)",
            "2 3 5",
        ),
        ("#if(1) #break #end", "E"),
        ("#macro M() F(1) #if(1) #break #end F(2) #end M() F(3)", "1 3"),
    ]);
}

#[test]
fn include_files() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(dir.path().join(name), text).unwrap();
    std::fs::create_dir(dir.path().join("sub")).unwrap();
    write("sub/a.inc", "#include \"b.inc\"");
    write("sub/b.inc", "F(2)");
    write("b.inc", "F(1)");
    write("noext", "F(3)");
    write("opens.inc", "#if(1) F(1)");
    write("skips.inc", "#if(0) F(1)");
    write("local.inc", "#local L=5; #declare G=L;");
    write("loops.inc", "#while(1)");
    write("itself.inc", "#include \"itself.inc\"");
    write("half.inc", "1 +");
    write("quoted.inc", "S(\"é\")");
    let library = || Library { current: dir.path().to_owned(), ..Library::default() };
    probe_in(
        &library,
        &[
            (r#"#include "sub/a.inc""#, "1"),
            (r#"#include "noext""#, "3"),
            (r#"#include concat("no","ext")"#, "3"),
            (r#"#include "opens.inc" F(2) #else F(3) #end F(4)"#, "1 2 4"),
            (r#"#include "skips.inc" F(2) #else F(3) #end F(4)"#, "3 4"),
            (r#"#include "skips.inc" #if(1) F(2) #end #elseif(1) F(3) #end F(4)"#, "3 4"),
            (r#"#include "local.inc" F(G) F(defined(L))"#, "5 0"),
            (r#"#include "loops.inc" #end"#, "E"),
            (r#"#include "itself.inc""#, "E"),
            (r#"#include "missing.inc""#, "E"),
            ("F((#include \"half.inc\" 2))", "3"),
            (r#"#include "b.inc" #include "b.inc""#, "1 1"),
        ],
    );
}

#[test]
fn versions_and_messages() {
    probe(&[
        ("F(version) #version 3.5; F(version)", "3.7 3.5"),
        ("#version 3.8;", "E"),
        ("#version unofficial 3.7; F(1)", "1"),
        ("#version version; F(version)", "3.7"),
        (r#"#warning "careful" F(1)"#, "1 W"),
        (r#"#error "stop" F(1)"#, "E"),
        (r#"#render "x\n""#, "x W"),
        ("#debug 3", "E"),
        ("#declare A=3; F(A) #foo", "3 E"),
        ("Foo(1)", "E"),
        (";", "E"),
        ("}", "E"),
        ("3", "E"),
    ]);
}
