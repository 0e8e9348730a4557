//! Old spellings that newer ones have taken the place of.

use super::{File, Scene};
use crate::diag::{Code, Diagnostic, Severity};
use crate::interp::Word;
use crate::source::Span;
use crate::syntax::{NodeKind, Punct};

/// Words that are old wherever they stand, and what to write instead.
const OLD: &[(Word, &str)] = &[
    (Word::Component, "write `sphere { CENTER, RADIUS, STRENGTH }` or `cylinder { … }`"),
    (Word::HfGray16, "it has no effect any more; say `Grayscale_Output=on` when rendering"),
    (Word::MaterialMap, "write a `texture` with an `image_pattern` and a `texture_map`"),
    (Word::MaxIntersections, "it has no effect any more; remove it"),
    (Word::ReflectionExponent, "write `reflection { … exponent … }`"),
];

/// Words that are old in a `finish`.
const OLD_IN_FINISH: &[Word] = &[Word::Ior, Word::Caustics, Word::Refraction];

/// Old words in the user's own files.
pub(super) fn spellings(scene: &Scene, found: &mut Vec<Diagnostic>) {
    for file in scene.own() {
        for (index, node) in file.tree.nodes.iter().enumerate() {
            let NodeKind::Word(symbol) = node.kind else { continue };
            let Some(word) = Word::of(symbol) else { continue };
            if let Some((_, help)) = OLD.iter().find(|(old, _)| *old == word) {
                found.push(old(word, file.tree.span(index), help));
            }
            if word == Word::Finish {
                in_finish(file, index + 1, found);
            }
        }
    }
}

fn in_finish(file: &File, start: usize, found: &mut Vec<Diagnostic>) {
    let mut depth = 0;
    for (index, node) in file.tree.nodes.iter().enumerate().skip(start) {
        match node.kind {
            NodeKind::Punct(Punct::OpenBrace) => depth += 1,
            NodeKind::Punct(Punct::CloseBrace) => depth -= 1,
            NodeKind::Word(symbol) if depth == 1 => {
                if let Some(word) = Word::of(symbol).filter(|word| OLD_IN_FINISH.contains(word)) {
                    let help = "light goes through solids: write it into the `interior { … }` of the object";
                    found.push(old(word, file.tree.span(index), help));
                }
            }
            _ => {}
        }
        if depth <= 0 {
            return;
        }
    }
}

fn old(word: Word, span: Span, help: &str) -> Diagnostic {
    let message = format!("`{}` is an old spelling here", word.text());
    Diagnostic::new(Severity::Warning, span, message).code(Code::Deprecated).help(help)
}
