//! Finds out which `#end`, `#else` or `#case` belongs to which directive.

use super::tree::{Node, NodeKind};

/// Chains the directives of each block: opener → arm → arm → `#end`. Those whose partner is in
/// another file keep their empty link.
pub(super) fn link(nodes: &mut [Node]) {
    let mut open: Vec<usize> = Vec::new();
    for index in 0..nodes.len() {
        let NodeKind::Directive(directive, _) = nodes[index].kind else { continue };
        if directive.opens() {
            open.push(index);
        } else if (directive.continues() || directive == super::Directive::End)
            && let Some(previous) = open.pop()
        {
            if let NodeKind::Directive(_, link) = &mut nodes[previous].kind {
                *link = index as u32;
            }
            if directive.continues() {
                open.push(index);
            }
        }
    }
}
