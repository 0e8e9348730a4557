//! `union`, `merge`, `intersection`, `difference` (docs/spec/primitives.md 7).

use std::sync::Arc;

use crate::interp::limits::MOST_OBJECTS;
use crate::interp::statement::object;
use crate::interp::{Block, Result, Vm, Word};
use crate::scene::depth::Nested;
use crate::scene::shape::{Csg, CsgOperation};
use crate::scene::{Object, Shape, object::ObjectFlags};

/// Reads the children. The flags are those the compound takes from them.
pub(super) fn read(vm: &mut Vm<'_>, block: &Block) -> Result<(Shape, ObjectFlags)> {
    let operation = match block.keyword {
        Word::Merge => CsgOperation::Merge,
        Word::Intersection => CsgOperation::Intersection,
        Word::Difference => CsgOperation::Difference,
        _ => CsgOperation::Union,
    };
    if block.keyword == Word::Composite {
        vm.deprecated(block.span, "`composite` is the old name of `union`", "write `union`");
    }
    let mut children: Vec<Arc<Object>> = Vec::new();
    while let Some(child) = object::any(vm)? {
        warn_about_patch(vm, operation, &child);
        children.push(child);
    }
    // One object was usual in version 1 scenes (docs/spec/language.md 2.11).
    if children.len() < 2 && vm.version >= 150 {
        let word = block.keyword.text();
        vm.warn(
            block.span,
            format!("this `{word}` has fewer than two members"),
            "a single object needs none",
        );
    }
    let parts = children.iter().map(|child| parts(child)).fold(0, u64::saturating_add);
    if parts > MOST_OBJECTS {
        let message = format!("this `{}` has more than {MOST_OBJECTS} parts", block.keyword.text());
        let fault = vm.error(block.span, message);
        return Err(fault.help("copies of copies add up: does a loop double them?"));
    }
    let textured = children.iter().any(|child| child.flags.contains(ObjectFlags::TEXTURED));
    let flags = if textured { ObjectFlags::TEXTURED } else { ObjectFlags::empty() };
    let children = Nested::new(children);
    Ok((Shape::Csg(Arc::new(Csg { operation, children, split_union: true, parts })), flags))
}

/// How many shapes an object consists of.
fn parts(object: &Object) -> u64 {
    match &object.shape {
        Shape::Csg(csg) => csg.parts,
        _ => 1,
    }
}

/// Surfaces without an inside give no solid.
fn warn_about_patch(vm: &mut Vm<'_>, operation: CsgOperation, child: &Object) {
    let solid = matches!(operation, CsgOperation::Intersection | CsgOperation::Difference);
    if solid && object::is_patch(&child.shape) {
        vm.warn(
            child.span,
            "a surface without an inside stands in a constructive solid",
            "only solids can be intersected or taken away; a mesh needs an `inside_vector`",
        );
    }
}
