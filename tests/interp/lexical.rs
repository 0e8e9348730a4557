use super::probe;

#[test]
fn comments_numbers_and_names() {
    probe(&[
        (r#"/* a /* b */ c */ #debug "ok\n""#, "ok"),
        ("/* a /* b */", "E"),
        ("F(.5) F(5.) F(1e3) F(1.5E-2) F(1.e2) F(1e)", "0.5 5 1000 0.015 100 1"),
        ("F(1..2)", "E"),
        ("F(5.x)", "E"),
        ("F(0x10)", "E"),
        ("#declare Foo=1; #declare foo=2; F(Foo)", "1"),
        ("F(1e400) F(123456789012345678901234567890)", "inf 123456789012345677877719597056"),
        ("#if(0) 1.2.3 #end", "E"),
        ("# /* so */ declare A=3; F(A)", "3"),
        ("# \n declare A=3; F(A)", "3"),
        ("#F(3)", "3"),
        ("F(2) \x1a F(3)", "2 3"),
    ]);
}

#[test]
fn strings() {
    probe(&[
        (r#"F(asc("\a")) F(asc("\u0041"))"#, "7 65"),
        (r#"#debug "a\qb""#, "E"),
        (r#"S("\x41")"#, "E"),
        (r#"#if(0) "a\qb" it's @ $ #end F(1)"#, "1"),
        (&format!("F(strlen(\"{}\"))", "a".repeat(255)), "255"),
        (&format!("S(\"{}\")", "a".repeat(256)), "E"),
        (r#"S("a\"b") S("a\\b")"#, r#"[a"b] [a\b]"#),
        ("#debug \"never closed", "E"),
        (r#"#debug "a" #debug "b" #debug "c\n""#, "abc"),
        ("F(strlen(\"é\"))", "2 P"),
    ]);
}

#[test]
fn names_of_more_than_255_characters_are_refused() {
    let (fits, too_long) = ("a".repeat(255), "a".repeat(256));
    probe(&[(&format!("#declare {fits}=1; F({fits})"), "1"), (&format!("#declare {too_long}=1;"), "E")]);
}
