//! Old spellings that newer ones have taken the place of, and that mean the same: of others, reading warns.

use super::Scene;
use crate::diag::{Code, Diagnostic, Severity};
use crate::interp::Word;
use crate::syntax::NodeKind;

/// Old words, and what to write instead.
const OLD: &[(Word, &str)] = &[
    (Word::Component, "write `sphere { CENTER, RADIUS, STRENGTH }` or `cylinder { … }`"),
    (Word::MaterialMap, "write a `texture` with an `image_pattern` and a `texture_map`"),
    (Word::ReflectionExponent, "write `reflection { … exponent … }`"),
];

/// Old words in the user's own files.
pub(super) fn spellings(scene: &Scene, found: &mut Vec<Diagnostic>) {
    for file in scene.own() {
        for (index, node) in file.tree.nodes.iter().enumerate() {
            let NodeKind::Word(symbol) = node.kind else { continue };
            let Some(&(word, help)) = OLD.iter().find(|(old, _)| Word::of(symbol) == Some(*old)) else {
                continue;
            };
            let message = format!("`{}` is an old spelling", word.text());
            found.push(
                Diagnostic::new(Severity::Warning, file.tree.span(index), message)
                    .code(Code::Deprecated)
                    .help(help),
            );
        }
    }
}
