//! `bounded_by { … }` and `clipped_by { … }` (docs/spec/primitives.md 7.6).

use std::sync::Arc;

use super::{modifier, object, transform};
use crate::interp::{Result, Vm, Word};
use crate::scene::depth::Nested;
use crate::scene::object::ObjectFlags;
use crate::scene::{Object, Shape};

/// Reads the block: objects and transforms of them all, or the other keyword to share its list.
pub(super) fn read(vm: &mut Vm<'_>, owner: &mut Object) -> Result<()> {
    let block = vm.enter()?;
    let clips = block.keyword == Word::ClippedBy;
    let other = if clips { Word::BoundedBy } else { Word::ClippedBy };
    let extra = modifier::extra(owner);
    if vm.accept(other)? {
        let taken = if clips { &extra.clipped_by } else { &extra.bounded_by };
        if !taken.is_empty() {
            return Err(vm.error(
                block.span,
                format!("this object has a `{}` already, which cannot be shared too", block.keyword.text()),
            ));
        }
        if clips {
            extra.clipped_by.clone_from(&extra.bounded_by);
        } else {
            extra.bounded_by.clone_from(&extra.clipped_by);
        }
        owner.flags |= ObjectFlags::BOUNDS_ARE_CLIPS;
        vm.close(block)?;
        return Ok(());
    }
    if owner.flags.contains(ObjectFlags::BOUNDS_ARE_CLIPS) {
        return Err(vm
            .error(block.span, "bounds and clips of this object are one list: nothing can be added")
            .help("list every object before sharing with `bounded_by { clipped_by }`"));
    }
    let mut objects = Vec::new();
    while let Some(object) = object::any(vm)? {
        check(vm, &object)?;
        objects.push(object);
    }
    if objects.is_empty() {
        return Err(vm.expected("an object"));
    }
    while let Some(by) = transform::item(vm)? {
        for object in &mut objects {
            Arc::make_mut(object).apply(&by);
        }
    }
    vm.close(block)?;
    let extra = modifier::extra(owner);
    let list = if clips { &mut extra.clipped_by } else { &mut extra.bounded_by };
    *list = Nested::new(list.iter().cloned().chain(objects).collect());
    Ok(())
}

fn check(vm: &Vm<'_>, object: &Object) -> Result<()> {
    if object::is_textured(object) {
        return Err(vm
            .error(object.span, "an object that clips or bounds cannot have a texture")
            .help("take its texture away: it would never be seen"));
    }
    if object::is_patch(&object.shape) {
        return Err(vm
            .error(object.span, "an object that clips or bounds has to have an inside")
            .help("use a solid, such as a `box`"));
    }
    Ok(())
}

/// Warns of bounds of a single shape at the top level: only their box counts, and only where it is
/// too small and cuts (docs/spec/primitives.md 8.3). A `poly` and a CSG gain from theirs.
pub(super) fn warn_of_superfluous(vm: &mut Vm<'_>, object: &Object) {
    let gains = matches!(object.shape, Shape::Csg(_) | Shape::Poly(_) | Shape::LightGroup(_));
    let bounded = object.extra.as_ref().is_some_and(|extra| !extra.bounded_by.is_empty());
    if bounded && !gains {
        vm.warn(object.span, "this object gains nothing from `bounded_by`", "it can be left out");
    }
}
