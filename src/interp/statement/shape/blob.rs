//! `blob { … }` (docs/spec/primitives.md 5.1).

use std::sync::Arc;

use super::cone;
use crate::interp::statement::object;
use crate::interp::{Block, Result, Vm, Word};
use crate::scene::depth::Nested;
use crate::scene::shape::{Blob, BlobComponent, BlobKind};
use crate::scene::{Object, Shape};

/// Reads threshold and components, in any order.
pub(super) fn read(vm: &mut Vm<'_>, block: &Block) -> Result<Shape> {
    let (mut threshold, mut components) = (1.0, Vec::new());
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Threshold => threshold = vm.after_word(Vm::read_float)?,
            Word::Sphere => components.push(component(vm, sphere)?),
            Word::Cylinder => components.push(component(vm, cylinder)?),
            Word::Component => components.push(vm.after_word(legacy)?),
            _ => break,
        }
    }
    if components.is_empty() {
        return Err(vm
            .error(block.span, "this blob has no component")
            .help("give it some, such as `sphere { <0,0,0>, 1, 1 }`"));
    }
    Ok(Shape::Blob(Arc::new(Blob { threshold, components: Nested::new(components) })))
}

fn sphere(vm: &mut Vm<'_>) -> Result<BlobKind> {
    let center = vm.read_vector()?;
    vm.comma()?;
    Ok(BlobKind::Sphere { center, radius: vm.read_float()? })
}

fn cylinder(vm: &mut Vm<'_>) -> Result<BlobKind> {
    let start = vm.here()?;
    let base = vm.read_vector()?;
    vm.comma()?;
    let cap = vm.read_vector()?;
    cone::check_length(vm, "cylinder", base, cap, start)?;
    vm.comma()?;
    Ok(BlobKind::Cylinder { base, cap, radius: vm.read_float()? })
}

/// Reads `sphere { … }` or `cylinder { … }` with its strength, transforms and texture.
fn component(vm: &mut Vm<'_>, kind: fn(&mut Vm<'_>) -> Result<BlobKind>) -> Result<BlobComponent> {
    let block = vm.enter()?;
    let kind = kind(vm)?;
    vm.comma()?;
    vm.accept(Word::Strength)?;
    let strength = vm.read_float()?;
    // A component takes the items of an object that concern place and surface: an object collects them.
    let mut placed = Object::new(block.span, Shape::Sphere { center: Default::default(), radius: strength });
    object::place_and_surface(vm, &mut placed)?;
    vm.close(block)?;
    Ok(BlobComponent { kind, strength, transform: placed.transform, texture: placed.texture })
}

/// Reads `component strength, radius, <center>`.
fn legacy(vm: &mut Vm<'_>) -> Result<BlobComponent> {
    let strength = vm.read_float()?;
    vm.comma()?;
    let radius = vm.read_float()?;
    vm.comma()?;
    let center = vm.read_vector()?;
    Ok(BlobComponent { kind: BlobKind::Sphere { center, radius }, strength, transform: None, texture: None })
}
