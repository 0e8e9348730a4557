//! `#default`s that another replaces before anything was made with them.

use super::{File, Scene};
use crate::diag::{Code, Diagnostic, Severity};
use crate::interp::Word;
use crate::source::Span;
use crate::syntax::{Directive, NodeKind, Punct};

/// A `#default` that has had no effect yet.
struct Pending {
    /// The part of a texture it sets.
    part: Word,
    span: Span,
}

/// What is set by one `#default` and then by another, with nothing in between that could have used it.
pub(super) fn overwritten(scene: &Scene, found: &mut Vec<Diagnostic>) {
    for file in scene.own() {
        let mut pending: Vec<Pending> = Vec::new();
        let mut at = 0;
        while let Some(node) = file.tree.nodes.get(at) {
            at += 1;
            match node.kind {
                NodeKind::Directive(Directive::Default, _) => {
                    let end = block_end(file, at);
                    for part in parts(file, at, end) {
                        replace(&mut pending, part, found);
                    }
                    at = end;
                }
                // Statements, names and directives but for these may use what is set.
                NodeKind::Word(_) => pending.clear(),
                NodeKind::Directive(Directive::Debug | Directive::Version, _) => {}
                NodeKind::Directive(..) => pending.clear(),
                _ => {}
            }
        }
    }
}

fn replace(pending: &mut Vec<Pending>, new: Pending, found: &mut Vec<Diagnostic>) {
    pending.retain(|old| {
        // A pigment only changes a part of a texture, a texture all of it.
        let replaced = old.part == new.part && new.part != Word::Finish || new.part == Word::Texture;
        if replaced {
            let message = format!("this default `{}` is replaced before anything uses it", old.part.text());
            found.push(
                Diagnostic::new(Severity::Warning, old.span, message)
                    .code(Code::OverwrittenDefault)
                    .see(new.span, "by this")
                    .help("remove it, or put all into one `#default`"),
            );
        }
        !replaced
    });
    pending.push(new);
}

/// The parts of a texture between two nodes that a `#default` sets.
fn parts(file: &File, start: usize, end: usize) -> Vec<Pending> {
    let mut depth = 0;
    let mut parts = Vec::new();
    for (index, node) in file.tree.nodes.iter().enumerate().take(end).skip(start) {
        match node.kind {
            NodeKind::Punct(Punct::OpenBrace) => depth += 1,
            NodeKind::Punct(Punct::CloseBrace) => depth -= 1,
            NodeKind::Word(symbol) if depth == 1 => {
                if let Some(part @ (Word::Texture | Word::Pigment | Word::Normal | Word::Finish)) =
                    Word::of(symbol)
                {
                    parts.push(Pending { part, span: file.tree.span(index) });
                }
            }
            _ => {}
        }
    }
    parts
}

/// The node after the block that starts at a node.
fn block_end(file: &File, start: usize) -> usize {
    let mut depth = 0;
    for (index, node) in file.tree.nodes.iter().enumerate().skip(start) {
        match node.kind {
            NodeKind::Punct(Punct::OpenBrace) => depth += 1,
            NodeKind::Punct(Punct::CloseBrace) if depth <= 1 => return index + 1,
            NodeKind::Punct(Punct::CloseBrace) => depth -= 1,
            _ if depth == 0 => return index,
            _ => {}
        }
    }
    file.tree.nodes.len()
}
