//! `contained_by { box { … } }` or `{ sphere { … } }` of `isosurface` and `parametric`.

use crate::interp::{Result, Vm, Word};
use crate::math::DVec3;
use crate::scene::shape::Container;

/// The container where none is written.
pub(super) const DEFAULT: Container = Container::Box { min: DVec3::NEG_ONE, max: DVec3::ONE };

/// Reads the block.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Container> {
    let block = vm.enter()?;
    let container = match vm.peek_word()? {
        Some(Word::Box) => {
            let inner = vm.enter()?;
            let (min, max) = super::box_::corners(vm)?;
            vm.close(inner)?;
            Container::Box { min, max }
        }
        Some(Word::Sphere) => {
            let inner = vm.enter()?;
            let center = vm.read_vector()?;
            vm.comma()?;
            let radius = vm.read_float()?;
            vm.close(inner)?;
            Container::Sphere { center, radius }
        }
        _ => return Err(vm.expected("`box` or `sphere`")),
    };
    vm.close(block)?;
    Ok(container)
}
