use super::{better, probe};

#[test]
fn declarations_that_are_refused() {
    probe(&[
        ("#declare f=function(x){!x}", "E"),
        ("#declare f=function(x){x^2}", "E"),
        ("#declare f=function(x){(x>0?1:2)}", "E"),
        ("#declare f=function(x){sqr(x)}", "E"),
        ("#declare f=function(x){rand(1)}", "E"),
        ("#declare f=function(x){version}", "E"),
        ("#declare f=function(x){x- -x} #declare g=function(x){- -x}", "E"),
        ("#declare f=function(x){x/0}", "E"),
        ("#declare f=function(x){sin(x,x)}", "E"),
        ("#declare A=1; #declare f=function(A){A}", "E"),
        ("#declare f=function(t){t}", "E"),
        ("#declare f=function(){1}", "E"),
        ("#declare f=function(x){Zork}", "E"),
        ("#declare f=function(x){Zork(x)}", "E"),
        ("#declare C=rgb 1; #declare f=function(x){C.x}", "E"),
        ("#declare f=function{internal(79)}", "E"),
        ("#declare g=function(x){x} #declare f=function(x){g(x,x)}", "E"),
        ("#declare g=function{spline{0,x 1,y}} #declare f=function(x){g(x)}", "E"),
    ]);
}

#[test]
fn declarations_that_are_accepted() {
    probe(&[
        ("#declare f=function(x,y,z){x|y&z=1+2*-sin(x)}", ""),
        ("#declare f=function(a b c){a+b*c+x} #declare g=f; #declare h=function(x){g(x,1,2)}", ""),
        ("#declare f=function{internal(17)} #declare g=function{f(x,y,z,1,2,3)}", ""),
        ("#declare f=function(x){sum(i,1,3,sum(j,1,i,j))*prod(i,1,4,i)}", ""),
        ("#declare g=function{spline{0,x 1,y}} #declare f=function(x){g(x).y+g(x).gray+g(x).hf}", ""),
        ("#declare A=array[2]{1,2} #declare f=function(x){A[1]*x+select(x,1,2)+max(x,1,2)+image_width}", ""),
        ("#macro M(a) a*2 #end #declare f=function(x){M(3) #if(1) +x #end}", ""),
    ]);
}

/// docs/spec/language.md 4.4.
#[test]
fn calls_give_what_pov_ray_gives() {
    probe(&[
        ("#declare f=function(x,y,z){x|y&z}; F(f(1,0,0))", "1"),
        ("#declare f=function(x,y,z){x+y<z*2}; F(f(1,2,3))", "1"),
        ("#declare f=function(x){x=1}; F(f(1+1e-12))", "0"),
        ("#declare f=function(u,v){x*10+y}; F(f(1,2)) #declare g=function(a){a+x+y+z}; F(g(2))", "12 2"),
        ("#declare f=function(x){sum(i,1,3,sum(j,1,i,j))}; F(f(0))", "10"),
        (
            "#declare f=function(x){prod(i,1,4,i)}; F(f(0)) #declare g=function(x){sum(i,3,1,i)}; F(g(0))",
            "24 0",
        ),
        ("#declare f=function(x){select(x,10,20)}; F(f(-1)) F(f(0)) F(f(1))", "10 20 20"),
        ("#declare f=function(x){8/x/2*3}; F(f(2)) #declare g=function(x){-pow(x,2)}; F(g(3))", "6 -9"),
        ("#declare g=function(x){x}; #declare f=function(x){g(12)/2*3}; F(f(0))", "2"),
        ("#declare g=function(x){x}; #declare f=function(x){g(x)/2*3}; F(f(12))", "18"),
        (
            "#declare f=function(x,y){atan2(x,y)}; F(f(0,0)) #declare g=function(x,y){pow(x,y)}; F(g(0,0))",
            "0 1",
        ),
        ("#declare f=function{transform{translate <1,2,3> scale 2}}; V(f(1,1,1))", "4,6,8"),
        (
            "#declare f=function(x){x*image_width}; F(f(2)) #declare C=5; #declare g=function(x){C*x}; #declare C=6; F(g(2))",
            "16 10",
        ),
        (
            "#declare f=function{pigment{gradient x color_map{[0 rgb <1,2,3>][1 rgbft <3,4,5,6,7>]}}} V5(f(.5,0,0))",
            "2,3,4,3,3.5",
        ),
        ("#declare f=function{internal(76)}; F(f(1.3,2.7,3.1))", "0.425048141254"),
        ("#declare f=function(x){x}; F(f(1,2))", "E"),
        ("#declare f=function(x,y){x}; F(f(1))", "E"),
        ("#declare f=function(x,y){x}; F(f(1,2,))", "E"),
    ]);
}

#[test]
fn compiled_things_answer_as_pov_ray_does() {
    probe(&[
        ("V(vturbulence(2,0.5,6,<0.1,0.2,0.3>))", "-0.049192392,-0.207178327,-0.554875161"),
        ("#declare B=sphere{0,1 scale 2} F(inside(B,x)) F(inside(B,x*3))", "1 0"),
        ("#declare B=sphere{0,1 scale 2} #declare N=<0,0,0>; V(trace(B,-10*z,z,N)) V(N)", "0,0,-2 0,0,-1"),
        ("#declare B=sphere{0,1 scale 2} #declare N=<1,1,1>; V(trace(B,-10*z,x,N)) V(N)", "0,0,0 0,0,0"),
        ("#declare B=sphere{0,1 scale <1,2,3>} V(min_extent(B)) V(max_extent(B))", "-1,-2,-3 1,2,3"),
        ("#declare B=sphere{0,1} V(trace(B,-10*z,z,N))", "E"),
        ("V(trace(sphere{0,1},-10*z,z))", "E"),
    ]);
}

/// docs/spec/language.md 4.2: a function that calls itself works as long as it ends.
#[test]
fn functions_may_call_themselves() {
    probe(&[
        ("#declare f=function(x){select(x,0,1,f(x-1)*x)} F(f(5))", "120 P"),
        ("#declare f=function(x){select(x-2,1,f(x-1)+f(x-2))} F(f(10))", "89 P P"),
        ("#declare f=function(x,y){select(x,0,y,f(x-1,y*x))} F(f(5,1))", "120 P"),
        ("#declare f=function(x){select(x,1,f(x-1,2))}", "E"),
        ("#declare f=function(x){sum(i,1,1e6,i)} F(f(1))", "500000500000"),
    ]);
    // POV-Ray crashes or hangs here.
    better(&[
        ("#declare f=function(x){f(x-1)+1} F(f(1))", "P E"),
        ("#declare f=function(x){select(x,1,f(x-1)+f(x-1))} F(f(60))", "P P E"),
        ("#declare f=function(x){sum(i,0,x,i)} F(f(1e300))", "E"),
        ("#declare f=function(x){prod(i,0,1e300,i)}", "E"),
    ]);
}

/// After an operand `<` compares, even where a vector could be read.
#[test]
fn a_vector_in_a_function_is_two_comparisons() {
    let g = "#declare g=function(x,y,z){x+10*y+100*z}";
    probe(&[
        (&format!("{g} #declare f=function(x,y){{g(x<1,2,3>y)}} F(f(0,1)) F(f(2,9))"), "121 20"),
        (&format!("{g} #declare f=function(x,y){{g(x*2<+1,-2,3>y+1)}} F(f(0,1)) F(f(2,9))"), "81 -20"),
        ("#declare f=function(x,y){min(x<-1,2>y)} #for(I,-2,0) F(f(I,1)) #end", "1 0 0"),
        ("#declare f=function(x,y){x<1,2>y}", "E"),
        ("#declare f=function(x,y){<1,2>y}", "E"),
        ("#declare f=function(x,y){sum(i x y i)}", "E"),
    ]);
}

#[test]
fn numbers_beside_each_other_are_combined_before_a_zero_is_noticed() {
    probe(&[
        ("#declare f=function(x){1/0} F(f(0))", "inf"),
        ("#declare f=function(x){1/0*x} F(f(0)) F(f(1))", "-nan inf"),
        ("#declare f=function(x){x*1/0}", "E"),
        ("#declare f=function(x){(1)/0}", "E"),
        ("#declare f=function(x){(1)/2*0}", "E"),
        ("#declare f=function(x){(1)/2*0*3}", "E"),
        ("#declare f=function(x){(3)*2/2*0} F(f(0))", "0"),
        ("#declare f=function(x){1/(0)} F(f(0))", "inf"),
        ("#declare f=function(x){acosh(x)} F(f(0))", "-nan"),
    ]);
}
