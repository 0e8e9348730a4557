//! `light_group { objects … }` (docs/spec/language.md 6.4, docs/spec/shading.md 18).

use std::sync::Arc;

use super::{modifier, object, photons};
use crate::interp::{Block, Result, Vm, Word};
use crate::scene::depth::Nested;
use crate::scene::shape::LightGroup;
use crate::scene::{Object, Shape};

/// Reads the rest of the statement after its brace: objects and lights, then what concerns them all.
pub(super) fn read(vm: &mut Vm<'_>, block: Block) -> Result<Object> {
    let (mut objects, mut global_lights) = (Vec::new(), false);
    while let Some(object) = object::any(vm)? {
        objects.push(object);
    }
    let mut object = Object::new(block.span, Shape::LightGroup(Arc::default()));
    loop {
        match vm.peek_word()? {
            Some(Word::GlobalLights) => global_lights = vm.after_word(Vm::read_flag)?,
            Some(Word::Photons) => photons::of_object(vm, &mut modifier::extra(&mut object).photons)?,
            _ => {
                if !modifier::place(vm, &mut object)? {
                    break;
                }
            }
        }
    }
    vm.close(block)?;
    object.shape = Shape::LightGroup(Arc::new(LightGroup { objects: Nested::new(objects), global_lights }));
    Ok(object)
}
