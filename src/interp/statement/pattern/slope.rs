//! `slope` (docs/spec/patterns-textures.md 2.8).

use crate::interp::stream::TokenKind;
use crate::interp::{Result, Vm, Word};
use crate::math::DVec3;
use crate::scene::Pattern;
use crate::scene::pattern::Slope;
use crate::syntax::Punct;

/// Reads `slope <direction>` or `slope { [point_at] V [, low, high] [altitude V [, low, high]] }`.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Pattern> {
    let keyword = vm.next()?;
    let mut slope = Slope { direction: DVec3::ZERO, point_at: false, range: [0.0, 1.0], altitude: None };
    let braced = vm.peek()?.kind == TokenKind::Punct(Punct::OpenBrace);
    if braced {
        let block = vm.open(keyword)?;
        slope.point_at = vm.accept(Word::PointAt)?;
        (slope.direction, slope.range) = directed(vm, !slope.point_at)?;
        if vm.accept(Word::Altitude)? {
            slope.altitude = Some(directed(vm, true)?);
        }
        vm.close(block)?;
    } else {
        slope.direction = direction(vm, true)?;
        if vm.accept(Word::Altitude)? {
            slope.altitude = Some((direction(vm, true)?, [0.0, 1.0]));
        }
    }
    Ok(Pattern::Slope(Box::new(slope)))
}

/// Reads a direction and its range.
fn directed(vm: &mut Vm<'_>, unit: bool) -> Result<(DVec3, [f64; 2])> {
    let direction = direction(vm, unit)?;
    vm.comma()?;
    let mut range = [0.0, 1.0];
    if vm.at_number()? {
        range[0] = vm.read_float()?;
        vm.comma()?;
        range[1] = vm.read_float()?;
    }
    Ok((direction, range))
}

fn direction(vm: &mut Vm<'_>, unit: bool) -> Result<DVec3> {
    let (direction, place) = vm.located(Vm::read_vector)?;
    if !unit {
        return Ok(direction);
    }
    direction.try_normalize().ok_or_else(|| {
        vm.error(place, "this direction has no length")
            .help("give the direction slopes are measured against, such as `y`")
    })
}
