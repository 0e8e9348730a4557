//! Whether two texts mean the same: the same tokens, and the same comments between them.

use super::piece::{comment_length, is_blank};
use crate::syntax::{Node, NodeKind, Tree};

/// Compares two files by their nodes and texts. Both have been read with the same symbols.
pub(super) fn is_same(one: (&Tree, &str), other: (&Tree, &str)) -> bool {
    one.0.nodes.len() == other.0.nodes.len()
        && other.0.errors.is_empty()
        && one.0.nodes.iter().zip(&other.0.nodes).all(|(a, b)| same_node((a, one), (b, other)))
        && comments(one) == comments(other)
}

fn same_node((a, one): (&Node, (&Tree, &str)), (b, other): (&Node, (&Tree, &str))) -> bool {
    let text = |node: &Node, text| -> String { slice(text, node.start, node.end).to_owned() };
    match (a.kind, b.kind) {
        (NodeKind::Number(_), NodeKind::Number(_)) | (NodeKind::Text, NodeKind::Text) => {
            text(a, one.1) == text(b, other.1)
        }
        (NodeKind::Vector(m, i), NodeKind::Vector(n, j)) => {
            let (v, w) = (one.0.vector(m, i), other.0.vector(n, j));
            v.iter().map(|c| c.to_bits()).eq(w.iter().map(|c| c.to_bits()))
        }
        (NodeKind::Directive(a, i), NodeKind::Directive(b, j)) => (a, i) == (b, j),
        (a, b) => a == b,
    }
}

fn slice(text: &str, start: u32, end: u32) -> &str {
    &text[start as usize..end as usize]
}

/// The comments, each with the number of the token before it and without the blanks at the ends of its lines.
fn comments((tree, text): (&Tree, &str)) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut at = 0;
    for index in 0..=tree.nodes.len() {
        let node = tree.nodes.get(index);
        comments_in(&text[at..node.map_or(text.len(), |node| node.start as usize)], index, &mut found);
        let Some(node) = node else { break };
        if matches!(node.kind, NodeKind::Directive(..)) {
            comments_in(slice(text, node.start + 1, node.end), index, &mut found);
        }
        at = node.end as usize;
    }
    found
}

fn comments_in(mut text: &str, index: usize, found: &mut Vec<(usize, String)>) {
    while let Some(at) = text.find('/') {
        text = &text[at..];
        let length = comment_length(text).unwrap_or(1);
        let lines: Vec<&str> = text[..length].split('\n').map(|line| line.trim_matches(is_blank)).collect();
        found.push((index, lines.join("\n")));
        text = &text[length..];
    }
}
