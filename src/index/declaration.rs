//! Where the value of a declaration ends, as far as the text tells.

use crate::syntax::{NodeKind, Punct, Tree};

/// The last node of the value that starts at `start`: its `;`, the brace that closes a statement, or what stands before
/// the next directive.
pub(super) fn end(tree: &Tree, start: usize) -> usize {
    let mut depth = 0_usize;
    for (index, node) in tree.nodes.iter().enumerate().skip(start) {
        match node.kind {
            NodeKind::Punct(Punct::Semicolon) if depth == 0 => return index,
            NodeKind::Directive(..) if depth == 0 => return index.saturating_sub(1).max(start),
            NodeKind::Punct(Punct::OpenBrace | Punct::OpenParen | Punct::OpenBracket) => depth += 1,
            NodeKind::Punct(Punct::CloseBrace) if depth <= 1 => {
                // A `;` may follow; a closing brace too many belongs to somebody else.
                let next = tree.nodes.get(index + 1).map(|node| node.kind);
                return match next {
                    _ if depth == 0 => index.saturating_sub(1).max(start),
                    Some(NodeKind::Punct(Punct::Semicolon)) => index + 1,
                    _ => index,
                };
            }
            NodeKind::Punct(Punct::CloseBrace | Punct::CloseParen | Punct::CloseBracket) => {
                depth = depth.saturating_sub(1);
            }
            _ => {}
        }
    }
    tree.nodes.len().saturating_sub(1)
}
