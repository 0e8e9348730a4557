use super::*;
use crate::source::{FileId, Source};

fn read(text: &str) -> (Index, Symbols) {
    let mut symbols = Word::symbols();
    let tree = crate::syntax::parse(FileId(0), &Source::new("a.pov", "", text.into()), &mut symbols);
    let index = Index::new(&tree, text, &symbols);
    (index, symbols)
}

const SCENE: &str = "#declare A = 1;
#macro M(B, C)
  #local D = B + A;
  #declare E = sphere { 0, D }
#end
#for (I, 1, 2) #declare F[I] = A; #end
#declare deprecated once \"no\" A = 2;
M(A, \"E and Foo\")";

#[test]
fn declarations_are_found_with_their_extents() {
    let (index, symbols) = read(SCENE);
    let found: Vec<(&str, Kind, &str, Option<usize>)> = index
        .declarations
        .iter()
        .map(|d| {
            let whole = &SCENE[d.whole.start as usize..d.whole.end as usize];
            (&**symbols.name(d.name), d.kind, whole, d.within)
        })
        .collect();
    let body = &SCENE[SCENE.find("#macro").unwrap()..SCENE.find("\n#for").unwrap()];
    assert_eq!(
        found,
        [
            ("A", Kind::Declare, "#declare A = 1;", None),
            ("M", Kind::Macro, body, None),
            ("B", Kind::Parameter, "B", Some(1)),
            ("C", Kind::Parameter, "C", Some(1)),
            ("D", Kind::Local, "#local D = B + A;", Some(1)),
            ("E", Kind::Declare, "#declare E = sphere { 0, D }", Some(1)),
            ("I", Kind::Counter, "#for (I", None),
            ("A", Kind::Declare, "#declare deprecated once \"no\" A = 2;", None),
        ]
    );
}

#[test]
fn uses_are_all_other_names_and_those_in_strings_are_mentioned() {
    let (index, symbols) = read(SCENE);
    let uses: Vec<&str> = index.uses.iter().map(|found| &**symbols.name(found.name)).collect();
    assert_eq!(uses, ["B", "A", "D", "I", "A", "M", "A"]);
    let mentioned: Vec<&str> = index.mentioned.iter().map(|&name| &**symbols.name(name)).collect();
    assert_eq!(mentioned, ["E"]);
}

#[test]
fn a_name_refers_to_its_macros_own_or_to_the_last_before() {
    let (index, symbols) = read(SCENE);
    let found = |name: &str, place: &str| {
        let at = SCENE.find(place).unwrap() as u32;
        let found = index.find(symbols.find(name).unwrap(), at).unwrap();
        (found.kind, SCENE[..found.span.start as usize].lines().count())
    };
    assert_eq!(found("B", "B + A"), (Kind::Parameter, 2));
    assert_eq!(found("A", "A;\n  #declare E"), (Kind::Declare, 1));
    assert_eq!(found("A", "A, \"E"), (Kind::Declare, 7));
    assert_eq!(found("M", "M(A"), (Kind::Macro, 2));
}

#[test]
fn no_text_is_too_odd() {
    for text in [
        "#declare",
        "#declare A",
        "#declare A =",
        "#macro",
        "#macro M",
        "#macro M(A",
        "#for",
        "#for (",
        "#declare A[",
        "}",
    ] {
        read(text);
    }
}
