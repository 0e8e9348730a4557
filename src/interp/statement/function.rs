//! Patterns, pigments and transforms as functions (docs/spec/language.md 4.3).

use std::sync::Arc;

use super::pattern::{self, Owner};
use super::{pigment, transform};
use crate::interp::{Result, Vm, Word};
use crate::scene::function::FunctionBody;

/// Reads the body of a function that is no expression: `pattern`, `pigment` or `transform`, the
/// word peeked. `None`, and nothing taken, when it is something else.
pub fn read_function_body(vm: &mut Vm, word: Word) -> Result<Option<FunctionBody>> {
    Ok(Some(match word {
        Word::Pattern => {
            let block = vm.enter()?;
            let Some(mut field) = pattern::read(vm, Owner::Function)? else {
                return Err(vm.expected("a pattern"));
            };
            pattern::end_list(vm, &field.pattern)?;
            while pattern::modifier(vm, &mut field)? {}
            vm.close(block)?;
            FunctionBody::Pattern(Arc::new(field))
        }
        Word::Pigment => {
            let empty = vm.state.empty();
            FunctionBody::Pigment(pigment::block(vm, &empty)?)
        }
        Word::Transform => FunctionBody::Transform(transform::braced(vm)?),
        _ => return Ok(None),
    }))
}
