//! The list of the language's words: as the program has it, as the documentation has it, as POV-Ray has it.

use povista::reference::{Status, page, words};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap_or_default()
}

#[test]
fn the_page_of_the_language_is_what_the_program_says() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/language.md");
    let page = page();
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(&file, &page).unwrap();
    }
    assert!(
        read("docs/language.md") == page,
        "docs/language.md is stale: `UPDATE_DOCS=1 cargo test --test reference`"
    );
}

/// The specification lists what the installed POV-Ray refuses to declare.
#[test]
fn the_words_are_those_that_pov_ray_reserves() {
    let specification = read("docs/spec/language.md");
    let section = specification.split("### 1.7").nth(1).unwrap().split("Not reserved").next().unwrap();
    let listed: BTreeSet<&str> =
        section.split('`').skip(1).step_by(2).flat_map(str::split_whitespace).collect();
    let ours: BTreeSet<&str> = words().into_iter().map(|(word, _)| word).collect();
    assert_eq!(ours.len(), 498);
    assert_eq!(ours, listed);
}

/// The manual's page of reserved words, where it is installed. It lists some that are free names in truth.
#[test]
fn the_words_of_the_manual_are_known() {
    let manual = Path::new("/usr/share/doc/povray/html/r3_3.html");
    let Ok(text) = fs::read(manual) else { return };
    let text = String::from_utf8_lossy(&text).into_owned();
    let known: BTreeSet<&str> = words().into_iter().map(|(word, _)| word).collect();
    let free = specified_free_names();
    let plain = without_tags(&text);
    let start = plain.find("aa_level").expect("the manual has no list of reserved words");
    let list = &plain[start..start + plain[start..].find("yes").unwrap()];
    let missing: Vec<&str> = list
        .split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .filter(|word| word.len() > 3 && word.contains('_'))
        .filter(|word| !known.contains(word) && !free.contains(*word))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// What is declared from outside a scene, and can be declared anew.
fn specified_free_names() -> BTreeSet<&'static str> {
    BTreeSet::from([
        "clock_delta",
        "final_clock",
        "final_frame",
        "frame_number",
        "image_height",
        "image_width",
        "initial_clock",
        "initial_frame",
        "input_file_name",
        "user_defined",
    ])
}

fn without_tags(text: &str) -> String {
    let mut plain = String::new();
    let mut inside = false;
    for c in text.chars() {
        match c {
            '<' => inside = true,
            '>' => inside = false,
            c if !inside => plain.push(c),
            _ => {}
        }
    }
    plain
}

/// Words that nothing in the reading of scenes asks for would be supported in name only.
#[test]
fn a_word_that_is_called_supported_is_read_somewhere() {
    let mut code = String::new();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/interp"), &mut code);
    let directives: BTreeSet<&str> = povista::syntax::DIRECTIVES.iter().map(|&(word, _)| word).collect();
    // What is left when the others are excluded: see `builtin::string` and `shape::csg`.
    let by_exclusion = ["datetime", "union"];
    let unread: Vec<&str> = words()
        .into_iter()
        .filter(|(_, status)| *status != Status::Idle)
        .map(|(word, _)| word)
        .filter(|word| !directives.contains(word) && !by_exclusion.contains(word))
        .filter(|word| !asks_for(&code, &camel(word)))
        .collect();
    assert!(unread.is_empty(), "{unread:?}");
}

fn asks_for(code: &str, variant: &str) -> bool {
    let wanted = format!("Word::{variant}");
    code.match_indices(&wanted).any(|(at, _)| {
        !code[at + wanted.len()..].starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_')
    })
}

/// `sky_sphere` is `SkySphere` in the code.
fn camel(word: &str) -> String {
    let capital = |part: &str| {
        let mut chars = part.chars();
        chars.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(chars).collect::<String>()
    };
    word.split('_').map(capital).collect()
}

fn collect(folder: &Path, code: &mut String) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, code);
        } else if path.file_name().is_some_and(|name| name != "word.rs") {
            code.push_str(&fs::read_to_string(&path).unwrap());
        }
    }
}
