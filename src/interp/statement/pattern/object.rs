//! `object { … }` as a pattern: inside or outside.

use crate::interp::statement::object;
use crate::interp::{Result, Vm};
use crate::scene::Pattern;

/// Reads `object {` and the object. The list follows before the brace ends.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Pattern> {
    // The brace is closed by `end_list`.
    let _open = vm.enter()?;
    let Some(inner) = object::any(vm)? else { return Err(vm.expected("an object")) };
    if object::is_patch(&inner.shape) {
        let help = "every point is outside of it: use a solid; a mesh needs an `inside_vector`";
        vm.warn(inner.span, "this object has no inside to make a pattern of", help);
    }
    vm.comma()?;
    Ok(Pattern::Object(inner))
}
