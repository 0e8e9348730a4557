use super::probe;

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
