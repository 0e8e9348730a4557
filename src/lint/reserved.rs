//! Names that look like reserved words.

use super::Scene;
use crate::diag::{Code, Diagnostic, Severity};
use crate::interp::Word;
use rustc_hash::FxHashSet;

/// The shortest reserved word that others are taken for.
const SHORTEST: usize = 5;

/// Names without a capital that are a reserved word but for an underscore, a digit or a letter.
pub(super) fn names(scene: &Scene, found: &mut Vec<Diagnostic>) {
    let mut said = FxHashSet::default();
    for declaration in scene.own().flat_map(|file| &file.index.declarations) {
        let name = scene.name(declaration.name);
        if name.chars().any(|c| c.is_ascii_uppercase()) {
            continue;
        }
        let Some(word) = looks_like(name).filter(|_| said.insert(declaration.name)) else { continue };
        let message = format!("`{name}` is easily taken for the reserved word `{word}`");
        found.push(
            Diagnostic::new(Severity::Warning, declaration.span, message)
                .code(Code::ReservedLooking)
                .help("names with a capital letter are never reserved, nor will be"),
        );
    }
}

/// The reserved word that a name looks like.
fn looks_like(name: &str) -> Option<&'static str> {
    let plain = |text: &str| text.replace('_', "");
    let bare = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
    Word::spellings().filter(|word| word.len() >= SHORTEST).find(|word| {
        plain(word) == plain(bare) || word.len() > SHORTEST && strsim::damerau_levenshtein(word, name) == 1
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_compared_without_what_is_easily_overlooked() {
        assert_eq!(looks_like("lookat"), Some("look_at"));
        assert_eq!(looks_like("light_sorce"), Some("light_source"));
        assert_eq!(looks_like("sphere2"), Some("sphere"));
        assert_eq!(looks_like("i"), None);
        assert_eq!(looks_like("rock"), None);
    }
}
