//! Isosurfaces that rely on the default `max_gradient`.

use super::Scene;
use crate::diag::{Code, Diagnostic, Severity};
use crate::interp::Word;
use crate::syntax::{NodeKind, Punct};

/// Isosurfaces with neither `max_gradient` nor `evaluate`.
pub(super) fn without_gradient(scene: &Scene, found: &mut Vec<Diagnostic>) {
    for file in scene.own() {
        let nodes = &file.tree.nodes;
        for (index, node) in nodes.iter().enumerate() {
            let is = |kind: NodeKind, word: Word| matches!(kind, NodeKind::Word(symbol) if Word::of(symbol) == Some(word));
            let opens =
                nodes.get(index + 1).is_some_and(|node| node.kind == NodeKind::Punct(Punct::OpenBrace));
            if !is(node.kind, Word::Isosurface) || !opens {
                continue;
            }
            let mut depth = 0;
            let mut says = false;
            for node in &nodes[index + 1..] {
                match node.kind {
                    NodeKind::Punct(Punct::OpenBrace) => depth += 1,
                    NodeKind::Punct(Punct::CloseBrace) => depth -= 1,
                    kind => says |= is(kind, Word::MaxGradient) || is(kind, Word::Evaluate),
                }
                if depth == 0 {
                    break;
                }
            }
            if !says {
                found.push(
                    Diagnostic::new(
                        Severity::Warning,
                        file.tree.span(index),
                        "this `isosurface` has no `max_gradient`, so 1.1 is taken",
                    )
                    .code(Code::MissingMaxGradient)
                    .help("a function that changes faster gets holes: find its steepest slope, and write `max_gradient`"),
                );
            }
        }
    }
}
