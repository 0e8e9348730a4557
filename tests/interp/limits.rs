use super::{better, probe};

#[test]
fn nothing_nests_without_end() {
    let many = 1_000_000;
    better(&[
        (&format!("F({}", "(".repeat(many)), "E"),
        (&format!("F({}1)", "-".repeat(many)), "E"),
        (&"/*".repeat(many), "E"),
        (&"#if(1)".repeat(many), "E"),
        (&"#macro M()".repeat(10_000), "E"),
        (&"<".repeat(many), "E"),
        (&"A[".repeat(10_000), "E"),
        ("#declare A=array[1]{1} F(A[A[A[A[0]-1]-1]-1])", "1"),
        (&"#declare A=".repeat(10_000), "E"),
        (&"{".repeat(many), "E"),
        (&"union {".repeat(many), "E"),
        (&format!("sphere {{ 0, 1 {}", "pigment { checker ".repeat(many / 10)), "E"),
        (&"texture { gradient x texture_map { [0 ".repeat(many / 10), "E"),
        (&"normal { average normal_map { [1 ".repeat(many / 10), "E"),
    ]);
}

/// Each is seen not to end after a hundred turns, whatever it makes.
#[test]
fn loops_that_cannot_end_are_refused() {
    let count = "#macro Count(n) #declare n=n+1; #end #macro Twice(n) Count(n) Count(n) #end ";
    better(&[
        ("#while(1) #end", "E"),
        ("#while(1) sphere{0,1} #end", "E"),
        ("#declare A=0; #while(1) #declare A=A+1; #if(A>1e9) sphere{0,A} #end #end", "E"),
        ("#declare A=0; #while(A<1) sphere{A,1} #end", "E"),
        ("#declare A=array[2]{0,1} #declare B=0; #while(A[1]>0) #declare B=B+1; #end", "E"),
        ("#declare C=(0 #while(1) +1 #end);", "E"),
        ("mesh{ #while(1) triangle{0,x,y} #end }", "E"),
        ("#declare I=1; #while(I>0) sphere{I,1} #declare I=I+1; #end", "E"),
        ("#declare I=0; #while(10>=I) sphere{I,1} #declare I=I-0.5; #end", "E"),
        (&format!("{count} #declare A=0; #declare B=0; #while(A<1) Twice(B) #end"), "E"),
    ]);
}

#[test]
fn loops_that_may_end_are_run() {
    let count = "#macro Count(n) #declare n=n+1; #end #macro Twice(n) Count(n) Count(n) #end ";
    probe(&[
        ("#declare A=300; #while(A>0) #declare A=A-1; #end F(A)", "0"),
        ("#declare A=1; #while(A>0) #declare A=A+1; #if(A>300) #declare A=-1; #end #end F(A)", "-1"),
        ("#declare A=0; #while(A<200000) #declare A=A+1; #end F(A)", "200000"),
        ("#declare A=0; #while(1) #declare A=A+1; #if(A>1000) #break #end #end F(A)", "1001"),
        (&format!("{count} #declare A=0; #while(A<1000) Twice(A) #end F(A)"), "1000"),
        ("#macro M(p) #while(p<1000) #declare Q=Q+1; #end #end #declare Q=0; M(Q) F(Q)", "1000"),
        ("#declare R=seed(1); #declare I=0; #while(rand(R)<0.999) #declare I=I+1; #end F((I>100))", "1"),
        ("#declare A=array[1]{0} #while(A[0]<1000) #declare A[0]=A[0]+1; #end F(A[0])", "1000"),
        (
            "#declare O=sphere{0,1} #declare N=<0,0,0>; #declare I=0; #while(vlength(N)=0) #declare I=I+1; \
          #declare P=trace(O,<I/200-2.001,0,-5>,z,N); #end F(I)",
            "201",
        ),
    ]);
}

/// What cannot be told beforehand is stopped by counting what makes nothing.
#[test]
fn loops_with_no_end_in_sight_are_stopped() {
    use povista::interp::check::check_with;
    let options = povista::options::LanguageOptions { max_steps: 10_000, ..Default::default() };
    let stopped = |text: &str| {
        let source = povista::source::Source::new("scene.pov", "", text.into());
        check_with(source, Default::default(), &options).failed()
    };
    for endless in [
        "#declare S=seed(1); #while(rand(S)<2) #end",
        "#macro M(n) #if(n>0) M(n-1) M(n-1) #end #end M(90)",
        "#for(I,0,1) #declare I=0; #end",
        "#declare A=array[9] #declare S=seed(1); #while(rand(S)<2) #declare A[rand(S)*9]=1; #end",
        "#declare S=seed(1); #while(rand(S)<2) #debug \"x\\n\" #end",
        "#declare S=seed(1); #while(rand(S)<2) #for(I,1,100) #end #end",
        "#declare S=seed(1); #for(I,1,9) #while(rand(S)<2) #end #end",
        "#declare S=seed(1); #while(rand(S)<2) #declare A=array[100000] #end",
        "#declare f=function(x){sum(i,1,x,i)} #for(I,0,1) #declare I=f(9999)*0; #end",
        // It would take fifty times what is allowed.
        "#for(I,1,600000) #end",
    ] {
        assert!(stopped(endless), "{endless}");
    }
    for long in [
        // As many steps with something made in between.
        "#for(I,1,30000) #if(mod(I,2000)=0) sphere{0,I} #end #end",
        "#declare A=array[30000] #for(I,0,29999) #declare A[I]=I; #end",
        // Nothing is made, but the end comes nearer.
        "#for(I,1,100000) #declare A=I; #end",
        "#for(I,1,300) #for(J,1,300) #declare A=I; #end #end",
        "#for(I,100000,1,-1) #end",
        "#declare I=0; #while(I<50000) #declare I=I+1; #end",
        "#declare I=0; #declare N=9000; #while(N>=I) #for(J,1,9) #end #declare I=I+1; #end",
        "#macro M(N) #declare I=0; #while(I!=N) #declare I=I+1; #end #end M(50000)",
        // One short one after another.
        &"#for(I,1,3000) #end ".repeat(30),
    ] {
        assert!(!stopped(long), "{long}");
    }
}

#[test]
fn copies_of_copies_add_up() {
    better(&[
        ("#declare O=sphere{0,1} #for(I,1,60) #declare O=union{object{O} object{O}} #end", "E"),
        ("#declare O=sphere{0,1} #for(I,1,20) #declare O=union{object{O} object{O}} #end F(1)", "1"),
    ]);
}

#[test]
fn what_is_no_text_is_no_scene() {
    use povista::interp::check::check_with;
    let bytes: Vec<u8> = (0..4096_u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    let source = povista::source::Source::new("noise.pov", "", bytes);
    let checked = check_with(source, Default::default(), &Default::default());
    assert!(checked.failed());
    assert_eq!(checked.diagnostics.len(), 1, "{checked}");
}
