//! Objects: a shape's statement with its modifiers, a copy of a variable, `object { … }`
//! (docs/spec/language.md 6.5 to 6.7).

use std::sync::Arc;

use super::{light_group, light_source, modifier, shape};
use crate::interp::value::Value;
use crate::interp::{Block, Result, Vm, Word};
use crate::scene::object::ObjectFlags;
use crate::scene::{Object, Shape};

/// Whether a word begins the statement of an object.
pub(in crate::interp) fn is_object(word: Word) -> bool {
    shape::is_shape(word) || matches!(word, Word::Object | Word::LightSource | Word::LightGroup)
}

/// Reads an object, as a statement or as a bare variable; `None` if something else comes next.
pub(in crate::interp) fn any(vm: &mut Vm<'_>) -> Result<Option<Arc<Object>>> {
    match vm.peek_word()? {
        Some(word) if is_object(word) => Ok(Some(Arc::new(statement(vm)?))),
        Some(_) => Ok(None),
        None => variable(vm),
    }
}

/// Takes the name of an object.
fn variable(vm: &mut Vm<'_>) -> Result<Option<Arc<Object>>> {
    if vm.names_number() {
        return Ok(None);
    }
    vm.accept_value(|value| match value {
        Value::Object(object) => Some(Arc::clone(object)),
        _ => None,
    })
}

/// Reads the statement of an object; its keyword comes next.
pub(in crate::interp) fn statement(vm: &mut Vm<'_>) -> Result<Object> {
    let block = vm.enter()?;
    vm.count_object(block.span)?;
    vm.nested_value(block.span, |vm| inside(vm, block))
}

fn inside(vm: &mut Vm<'_>, block: Block) -> Result<Object> {
    let mut object = if let Some(named) = variable(vm)? {
        let mut copy = Arc::unwrap_or_clone(named);
        copy.span = block.span;
        copy
    } else {
        match block.keyword {
            Word::LightSource => return light_source::read(vm, block),
            Word::LightGroup => return light_group::read(vm, block),
            Word::Object => match any(vm)? {
                Some(object) => Arc::unwrap_or_clone(object),
                None => return Err(vm.expected("an object")),
            },
            _ => {
                let (shape, flags) = shape::read(vm, &block)?;
                let mut object = Object::new(block.span, shape);
                object.flags = flags;
                object
            }
        }
    };
    while modifier::read(vm, &mut object)? {}
    vm.close(block)?;
    modifier::check(vm, &object)?;
    Ok(object)
}

/// Reads what concerns the place and the surface of an object: transforms, textures and their parts.
pub(super) fn place_and_surface(vm: &mut Vm<'_>, object: &mut Object) -> Result<()> {
    while modifier::place(vm, object)? || modifier::surface(vm, object)? {}
    Ok(())
}

/// Whether a shape is a surface without an inside.
pub(super) fn is_patch(shape: &Shape) -> bool {
    match shape {
        Shape::Triangle(_) | Shape::BicubicPatch(_) | Shape::Parametric(_) => true,
        Shape::Mesh(mesh) => mesh.inside_vector.is_none(),
        Shape::Light(light) => light.looks_like.is_none(),
        _ => false,
    }
}

/// Whether an object, or a member of it, was given a texture.
pub(super) fn is_textured(object: &Object) -> bool {
    object.texture.is_some() || object.flags.contains(ObjectFlags::TEXTURED)
}
