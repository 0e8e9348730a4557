//! `pavement` (docs/spec/patterns-textures.md 2.7.3).

use crate::interp::{Result, Vm, Word};
use crate::scene::Pattern;
use crate::scene::pattern::Pavement;
use crate::source::Span;

/// The pattern before any setting.
pub(super) fn plain() -> Pattern {
    Pattern::Pavement(Pavement { sides: 3, tiles: 1, pattern: 1, exterior: 0, interior: 0, form: 0 })
}

/// Reads the value of a setting, whose word has been taken.
pub(super) fn option(vm: &mut Vm<'_>, pavement: &mut Pavement, word: Word) -> Result<()> {
    let target = match word {
        Word::NumberOfSides => &mut pavement.sides,
        Word::NumberOfTiles => &mut pavement.tiles,
        Word::Pattern => &mut pavement.pattern,
        Word::Exterior => &mut pavement.exterior,
        Word::Interior => &mut pavement.interior,
        _ => &mut pavement.form,
    };
    *target = vm.read_count()?;
    Ok(())
}

/// Refuses numbers that no pavement has, once all of them are known.
pub(super) fn check(vm: &Vm<'_>, pavement: &Pavement, place: Span) -> Result<()> {
    let patterns: &[u32] = match pavement.sides {
        3 => &[1, 1, 1, 3, 4, 12],
        4 => &[1, 1, 2, 5, 12, 35],
        6 => &[1, 1, 3, 7, 22],
        sides => {
            return Err(vm
                .error(place, format!("tiles with {sides} sides don't pave a plane"))
                .help("sides are 3, 4 or 6"));
        }
    };
    let tiles = pavement.tiles;
    let Some(&most) = tiles.checked_sub(1).and_then(|index| patterns.get(index as usize)) else {
        let message =
            format!("`number_of_tiles` is 1 to {} for {} sides, not {tiles}", patterns.len(), pavement.sides);
        return Err(vm.error(place, message));
    };
    if !(1..=most).contains(&pavement.pattern) {
        let message = format!("`pattern` is 1 to {most} for {tiles} tiles of {} sides", pavement.sides);
        return Err(vm.error(place, message));
    }
    Ok(())
}
