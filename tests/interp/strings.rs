use super::probe;

#[test]
fn string_functions() {
    probe(&[
        (
            "S(str(2.5,0,0)) S(str(3.5,0,0)) S(str(3.14159,-10,3)) S(str(1/3,0,20)) S(str(1e300,0,2)) S(str(-0.0,0,2))",
            "[2] [4] [000003.142] [0.33333333333333331483] [1e+300] [-0.00]",
        ),
        (r#"S(vstr(3,7,",",0,1)) S(vstr(9,<1,2,3>,",",0,1))"#, "[7.0,0.0,0.0] [1.0,2.0,3.0,0.0,0.0]"),
        (r#"S(substr("abcdef",2,3)) S(substr("abc",1,0))"#, "[bcd] []"),
        (r#"S(substr("abcdef",5,3))"#, "E"),
        (
            r#"F(val("12.5abc")) F(val("0x10")) F(val("abc")) F(val("-3e2x")) F(val(" 1e"))"#,
            "12.5 16 0 -300 1",
        ),
        (r#"F(strcmp("abc","ab")) F(strcmp("A","a"))"#, "99 -32"),
        (r#"S(datetime(1.5,"%H:%M:%S")) S(datetime(0))"#, "[12:00:00] [2000-01-01 00:00:00Z]"),
        (r#"S(datetime(0,""))"#, "E"),
        (r#"S(concat("a" "b","c")) S(chr(65)) S(strupr("aBc")) S(strlwr("aBc"))"#, "[abc] [A] [ABC] [abc]"),
        ("S(chr(-1))", "E"),
        (r#"F(strlen("abc")) F(asc("A")) F(asc(""))"#, "3 65 0"),
        (r#"F(file_exists("no such file"))"#, "0"),
        ("S(3)", "E"),
    ]);
}
