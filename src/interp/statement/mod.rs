//! Readers of statements: one block of the language to a file.

use super::value::Value;
use super::{Result, Vm, Word};
use crate::scene::Scene;
use crate::scene::function::FunctionBody;
use crate::source::Span;

/// What the statements of a scene have said so far.
#[derive(Debug, Default)]
pub struct State {}

/// Reads the statement a reserved word starts, as the value of a declaration or an argument of a
/// macro. The word is peeked, not taken. `None`, and nothing taken, when it starts no such thing.
pub fn read_rvalue(_: &mut Vm, _: Word) -> Result<Option<Value>> {
    Ok(None)
}

/// Reads the body of a function that is no expression: `pattern`, `pigment` or `transform`, the
/// word peeked. `None`, and nothing taken, when it is something else.
pub fn read_function_body(_: &mut Vm, _: Word) -> Result<Option<FunctionBody>> {
    Ok(None)
}

/// Reads a statement at the top level of the scene. `false`, and nothing taken, when none starts
/// there.
pub fn read_top_level(_: &mut Vm) -> Result<bool> {
    Ok(false)
}

/// Reads what follows `#default`.
pub fn read_default(vm: &mut Vm, span: Span) -> Result<()> {
    Err(vm.error(span, "`#default` is not supported yet"))
}

/// The scene that was read, without error.
pub fn finish(_: Vm) -> Option<Scene> {
    None
}
