use super::*;

/// The layout of a text, which a second run leaves alone.
fn laid_out(text: &str) -> String {
    let lay = |text: &str| format(FileId(0), &Source::new("a.pov", "", text.into())).unwrap();
    let once = lay(text);
    assert_eq!(lay(&once), once, "not the same when laid out again");
    once
}

#[test]
fn lines_are_indented_by_what_is_around_them() {
    let text = "union{\nsphere{0,1\npigment{ color rgb\t1 }}\n box { -1, 1 }\n   }\n#if (1)\n#declare A = 3;\n#else\n#while(1)\nA\n#end\n#end";
    let expected = "\
union {
  sphere { 0, 1
    pigment { color rgb 1 } }
  box { -1, 1 }
}
#if (1)
  #declare A = 3;
#else
  #while (1)
    A
  #end
#end
";
    assert_eq!(laid_out(text), expected);
}

#[test]
fn cases_are_indented_in_their_switch() {
    let text = "#switch(A)\n#case(1)\nB\n#break\n#range(2,3)\nC\n#else\nD\n#end\nE";
    let expected =
        "#switch (A)\n  #case (1)\n    B\n    #break\n  #range (2, 3)\n    C\n  #else\n    D\n#end\nE\n";
    assert_eq!(laid_out(text), expected);
}

#[test]
fn a_brace_opened_in_an_arm_is_closed_after_its_end() {
    let text =
        "#if (A)\nunion {\n#else\nmerge {\n#end\nsphere { 0, 1 }\n}\nbox { 0, 1 }\n#if (B)\n}\n#end\nC";
    let expected = "\
#if (A)
  union {
#else
  merge {
#end
  sphere { 0, 1 }
}
box { 0, 1 }
#if (B)
  }
#end
C
";
    assert_eq!(laid_out(text), expected);
}

#[test]
fn a_guard_around_the_whole_file_does_not_indent_it() {
    let guarded = "// colors\n#ifndef (Inc)\n#declare Inc = 1;\n#if (A)\n  B\n#end\n#end\n";
    assert_eq!(laid_out(guarded), guarded);
    assert_eq!(laid_out("#ifndef (Inc)\nA\n#end\nB"), "#ifndef (Inc)\n  A\n#end\nB\n");
}

#[test]
fn blanks_are_set_where_everybody_wants_them() {
    let rows = [
        ("sphere{<0,1,-2>,.5}", "sphere { <0, 1, -2>, .5 }"),
        ("#declare   A=1 ;", "#declare   A = 1;"),
        ("#  declare A=sin(x*2) ; // c", "#declare A = sin(x*2); // c"),
        ("#macro M(A,B) A+B#end", "#macro M(A, B) A+B #end"),
        ("rotate<A,B,C>translate x", "rotate <A, B, C> translate x"),
        ("#if(A<B)#debug\"x\"#end", "#if (A<B) #debug \"x\" #end"),
        ("f ( 1 , 2 )//x  \r\n", "f ( 1, 2 ) //x"),
        ("array[3]{1,2,3}", "array[3] { 1, 2, 3 }"),
        ("a{}", "a {}"),
        ("<  1,2>", "<  1, 2>"),
    ];
    for (text, expected) in rows {
        assert_eq!(laid_out(text).trim_end(), expected);
    }
}

#[test]
fn columns_that_were_lined_up_stay_lined_up() {
    let text = "color_map{\n[0.0   color Red]     // one\n[0.55  color Green]   // two\n}";
    let expected = "color_map {\n  [0.0   color Red]     // one\n  [0.55  color Green]   // two\n}\n";
    assert_eq!(laid_out(text), expected);
    let text = "translate 1     // a\nrotate<1,2>     // b";
    assert_eq!(laid_out(text), "translate 1     // a\nrotate <1, 2>   // b\n");
}

#[test]
fn what_hangs_under_a_bracket_stays_under_it() {
    let text = " matrix<1,0,\n        0,1,\n   2,3>\nf(a,\n  b)";
    assert_eq!(laid_out(text), "matrix <1, 0,\n        0, 1,\n  2, 3>\nf(a,\n  b)\n");
    let text = "map{\n[0 color A\n   color B ]\n}";
    assert_eq!(laid_out(text), "map {\n  [0 color A\n     color B ]\n}\n");
}

#[test]
fn an_expression_that_goes_on_is_indented_but_the_statement_of_a_declaration_is_not() {
    let text = "#declare A =\n1 +\n2;\n#declare B =\nunion {\nC\n}\n#declare D =\nunion\n{\nC\n}";
    let expected = "\
#declare A =
  1 +
  2;
#declare B =
union {
  C
}
#declare D =
union
{
  C
}
";
    assert_eq!(laid_out(text), expected);
}

#[test]
fn comments_and_strings_stay_what_they_are() {
    let text = "a{ /* one\n     two  \n\n  three */ b // four /*\t \n\"five \n   six\" }";
    let expected = "a { /* one\n     two\n\n  three */ b // four /*\n  \"five \n   six\" }\n";
    assert_eq!(laid_out(text), expected);
    let text = "a {\n/* one\n   two */\n}";
    assert_eq!(laid_out(text), "a {\n  /* one\n     two */\n}\n");
    assert_eq!(laid_out("#/* a */declare B=1;"), "#/* a */declare B = 1;\n");
}

#[test]
fn empty_lines_stay_up_to_two() {
    assert_eq!(laid_out("\n\na\n\n\n\n\nb\n\nc \r\n\r\n"), "a\n\n\nb\n\nc\n");
    assert_eq!(laid_out(" \n\t\n"), "");
}

#[test]
fn a_text_with_a_mistake_in_a_token_is_refused() {
    for text in ["\"open", "/* open", "1.2.3", "a § b"] {
        let refusal = format(FileId(0), &Source::new("a.pov", "", text.into())).unwrap_err();
        assert!(matches!(refusal, Refusal::Mistakes(mistakes) if mistakes.len() == 1), "{text}");
    }
}
