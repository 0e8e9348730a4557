//! The rules of the house that a reader of the files can check: who imports whom, how long a file
//! may be, and who prints.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The modules of the library: each imports only from those before it.
const ORDER: [&str; 16] = [
    "math",
    "source",
    "diag",
    "options",
    "syntax",
    "fmt",
    "scene",
    "world",
    "compile",
    "interp",
    "reference",
    "index",
    "lint",
    "lsp",
    "render",
    "cli",
];

/// Imports the order would allow, but the design doesn't: the compiled scene knows nothing of the
/// description it was made from.
const FORBIDDEN: [(&str, &str); 1] = [("world", "scene")];

/// The longest a file may be.
const LINES: usize = 500;

/// One source file of the library, without comments, strings and its own tests.
struct Module {
    file: PathBuf,
    /// The names down to the module, `["world", "shape", "sphere"]`.
    path: Vec<String>,
    code: String,
}

#[test]
fn a_module_imports_only_from_its_left() {
    let mut wrong = Vec::new();
    for module in library() {
        let name = module.path[0].as_str();
        let Some(place) = ORDER.iter().position(|&other| other == name) else {
            wrong.push(format!("{}: `{name}` has no place in the order of modules", module.file.display()));
            continue;
        };
        for import in imports(&module.path, &module.code) {
            let later = ORDER[place + 1..].contains(&import.as_str());
            if later || FORBIDDEN.contains(&(name, &import)) {
                wrong.push(format!("{}: `{name}` imports `{import}`", module.file.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_parts_of_a_layer_form_no_cycle() {
    check_cycles("world");
    check_cycles("interp");
}

/// Takes what a layer's root offers for given: the parts themselves must not go in circles.
fn check_cycles(layer: &str) {
    let root = format!("crate::{layer}::");
    let mut uses: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for module in library().into_iter().filter(|module| module.path.len() > 1 && module.path[0] == layer) {
        let part = module.path[1].clone();
        let mut named: BTreeSet<String> = words(&module.code, &root).flat_map(first_names).collect();
        named.extend(parents(&module.code, module.path.len() - 1));
        named.remove(&part);
        uses.entry(part).or_default().extend(named);
    }
    // Take away parts that use none of those left, until nothing changes: what stays is in a circle or uses one.
    let parts: BTreeSet<String> = uses.keys().cloned().collect();
    uses.values_mut().for_each(|named| named.retain(|name| parts.contains(name)));
    while let Some(free) = uses.iter().find(|(_, named)| named.is_empty()).map(|(part, _)| part.clone()) {
        uses.remove(&free);
        for named in uses.values_mut() {
            named.remove(&free);
        }
    }
    assert!(uses.is_empty(), "parts of `{layer}` that use each other in a circle: {uses:?}");
}

#[test]
fn no_file_is_too_long() {
    let mut long = Vec::new();
    for folder in ["src", "grammar", "tests", "benches", "compat/src", "compat/tests"] {
        for file in files(&root().join(folder), &["rs", "pest"]) {
            let lines = fs::read_to_string(&file).unwrap().lines().count();
            if lines > LINES {
                long.push(format!("{} has {lines} lines", file.display()));
            }
        }
    }
    assert!(long.is_empty(), "more than {LINES} lines:\n{}", long.join("\n"));
}

#[test]
fn only_the_command_prints() {
    let mut printing = Vec::new();
    for module in library().into_iter().filter(|module| module.path[0] != "cli") {
        for print in ["print!", "println!", "eprint!", "eprintln!", "dbg!"] {
            if words(&module.code, print).next().is_some() {
                printing.push(format!("{} uses {print}", module.file.display()));
            }
        }
    }
    assert!(printing.is_empty(), "{}", printing.join("\n"));
}

#[test]
fn imports_are_found_however_they_are_written() {
    let found = |path: &[&str], text: &str| -> Vec<String> {
        let path: Vec<String> = path.iter().map(|name| (*name).to_owned()).collect();
        imports(&path, &code_of(text)).into_iter().collect()
    };
    assert_eq!(found(&["world", "ray"], "use crate::scene::Object;"), ["scene"]);
    assert_eq!(
        found(&["world"], "use crate::{math::{Bounds, interp}, diag,\n render::trace};"),
        ["diag", "math", "render"]
    );
    assert_eq!(found(&["world", "ray"], "fn f() { super::super::cli::run() }"), ["cli"]);
    assert!(found(&["world", "shape", "sphere"], "use super::super::scene;").is_empty());
    assert!(found(&["world"], "// crate::cli\n/* crate::interp /* */ crate::cli */").is_empty());
    assert!(
        found(&["world"], "let a = (\"crate::cli \\\" crate::cli\", r#\"crate::\"cli\"#, '\"');").is_empty()
    );
    assert_eq!(found(&["world"], "fn f<'a>(x: &'a str) { crate::math::g('\\'', '\"') }"), ["math"]);
    assert!(found(&["world"], "struct A;\n#[cfg(test)]\nmod tests { use crate::cli; }").is_empty());
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every module of the library but its root, tests left out.
fn library() -> Vec<Module> {
    let src = root().join("src");
    let mut modules = Vec::new();
    for file in files(&src, &["rs"]) {
        let below = file.strip_prefix(&src).unwrap().with_extension("");
        let mut path: Vec<String> = below.iter().map(|name| name.to_str().unwrap().to_owned()).collect();
        if path.last().is_some_and(|name| name == "mod") {
            path.pop();
        }
        let is_root = path == ["lib"] || path == ["main"];
        let is_test = path.iter().any(|name| name == "tests" || name == "battery");
        if !is_root && !is_test {
            let code = code_of(&fs::read_to_string(&file).unwrap());
            modules.push(Module { file: below, path, code });
        }
    }
    assert!(modules.len() >= ORDER.len(), "found too few modules in {}", src.display());
    modules
}

/// All files below `folder` with one of the extensions, sorted.
fn files(folder: &Path, extensions: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, extensions));
        } else if path.extension().is_some_and(|e| extensions.iter().any(|&wanted| e == wanted)) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The modules at the crate's root that a module's code names.
fn imports(path: &[String], code: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for rest in words(code, "crate::") {
        found.extend(first_names(rest));
    }
    found.extend(parents(code, path.len()));
    found
}

/// The names that code reaches by going exactly so many modules `up`.
fn parents(code: &str, up: usize) -> Vec<String> {
    let mut found = Vec::new();
    for rest in words(code, "super::") {
        let (mut rest, mut ups) = (rest, 1);
        while let Some(further) = rest.strip_prefix("super::") {
            (rest, ups) = (further, ups + 1);
        }
        if ups == up {
            found.extend(first_names(rest));
        }
    }
    found
}

/// What follows each `word` that isn't the end of a longer path or name.
fn words<'a>(code: &'a str, word: &'a str) -> impl Iterator<Item = &'a str> {
    code.match_indices(word)
        .filter(|(at, _)| !code[..*at].ends_with(|c: char| c.is_alphanumeric() || "_:".contains(c)))
        .map(|(at, _)| &code[at + word.len()..])
}

/// The first name of a path, or of every path in a braced group.
fn first_names(rest: &str) -> Vec<String> {
    let Some(group) = rest.strip_prefix('{') else {
        return vec![name_at(rest)];
    };
    let mut names = vec![name_at(group)];
    let mut depth = 0;
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => names.push(name_at(&group[at + 1..])),
            _ => {}
        }
    }
    names
}

fn name_at(text: &str) -> String {
    text.trim_start().chars().take_while(|&c| c.is_alphanumeric() || c == '_').collect()
}

/// Rust text with comments, strings and characters blanked and the tests at its end cut off.
fn code_of(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    let mut code = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let skipped = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            block_comment(rest)
        } else if rest.starts_with("r\"") || rest.starts_with("r#") {
            raw_string(rest)
        } else if c == '"' {
            quoted(rest, '"')
        } else if c == '\'' && (rest[1..].starts_with('\\') || rest.chars().nth(2) == Some('\'')) {
            quoted(rest, '\'')
        } else {
            0
        };
        if skipped > 0 {
            code.push(' ');
            rest = &rest[skipped..];
        } else {
            code.push(c);
            rest = &rest[c.len_utf8()..];
        }
    }
    code
}

/// The length of the comment `text` begins with; block comments nest.
fn block_comment(text: &str) -> usize {
    let (mut at, mut depth) = (0, 0);
    while at < text.len() {
        if text[at..].starts_with("/*") {
            (at, depth) = (at + 2, depth + 1);
        } else if text[at..].starts_with("*/") {
            (at, depth) = (at + 2, depth - 1);
            if depth == 0 {
                return at;
            }
        } else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    text.len()
}

/// The length of the raw string `text` begins with; 0 where it is only a raw name.
fn raw_string(text: &str) -> usize {
    let hashes = text[1..].chars().take_while(|&c| c == '#').count();
    if !text[1 + hashes..].starts_with('"') {
        return 0;
    }
    let end = format!("\"{}", "#".repeat(hashes));
    let body = hashes + 2;
    text[body..].find(&end).map_or(text.len(), |at| body + at + end.len())
}

/// The length of the string or character `text` begins with.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            c if c == quote => return at + 1,
            _ => {}
        }
    }
    text.len()
}
