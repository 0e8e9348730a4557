use super::{probe_in, run};
use povista::source::Library;

#[test]
fn reading() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(dir.path().join(name), text).unwrap();
    write("three", "1,2,3");
    write("comma", "3, 4,\n");
    write("kinds", "<1,2>, <1,-2,3>, \"text\", -5, /* c */ <1 2 3>");
    write("bad", "1, sphere");
    let library = || Library { current: dir.path().to_owned(), ..Library::default() };
    probe_in(
        &library,
        &[
            (r#"#fopen H "three" read #while(defined(H)) #read(H,a) F(a) #end"#, "1 2 3"),
            (r#"#fopen H "three" read #read(H,a,b) #read(H,c,d) F(c) F(defined(d)) F(defined(H))"#, "3 0 0"),
            (
                r#"#fopen H "comma" read #read(H,a) #read(H,a) F(a) F(defined(H)) #read(H,a) F(a) F(defined(H))"#,
                "4 1 4 0",
            ),
            (
                r#"#fopen H "kinds" read #read(H,a,b,c,d,e) V2(a) V(b) S(c) F(d) V(e)"#,
                "1,2 1,-2,3 [text] -5 1,2,3",
            ),
            (r#"#fopen H "bad" read #read(H,a,b)"#, "E"),
            (r#"#fopen H "three" read #write(H,1)"#, "E"),
            (r#"#fopen H "three" read #fopen H "three" read"#, "E"),
            (r#"#fopen H "missing" read"#, "E"),
            (r#"#declare X=3; #fclose X #fclose Zork F(1)"#, "1"),
            (r#"#read(Zork,a)"#, "E"),
            (r#"#fopen H "three" read #fclose H F(defined(H))"#, "0"),
        ],
    );
}

#[test]
fn writing() {
    let dir = tempfile::tempdir().unwrap();
    let written = |items: &str| {
        let library = Library { current: dir.path().to_owned(), ..Library::default() };
        let checked = run(&format!("#fopen H \"out\" write #write({items}) #fclose H"), library);
        assert!(!checked.failed(), "{checked}");
        std::fs::read(dir.path().join("out")).unwrap()
    };
    assert_eq!(
        written(r#"H,1,",",2.5,"\n",<1,2>,<1,2,3>,1/3," ",1e10," ",123456789"#),
        b"1,2.5\n<1,2> <1,2,3> 0.333333 1e+10 1.23457e+08"
    );
    assert_eq!(written("H,uint8 1,2,300"), b"\x012300");
    assert_eq!(
        written("H,sint16be <1,2,3> 258, uint16le 258, sint32be -2, sint8 200, sint32le 1e12"),
        b"\x00\x01\x00\x02\x00\x03\x01\x02\x02\x01\xff\xff\xff\xfe\x7f\xff\xff\xff\x7f"
    );
}

#[test]
fn a_color_is_only_written_as_an_expression() {
    let dir = tempfile::tempdir().unwrap();
    let library = || Library { current: dir.path().to_owned(), ..Library::default() };
    let start = "#declare C=rgb <1,2,3>; #fopen H \"out\" write ";
    probe_in(&library, &[(&format!("{start}#write(H,C)"), "E"), (&format!("{start}#write(H,1*C)"), "")]);
}
