//! `slope` (docs/spec/patterns-textures.md 2.8).

use crate::interp::stream::TokenKind;
use crate::interp::{Experimental, Result, Vm, Word};
use crate::math::DVec3;
use crate::scene::Pattern;
use crate::scene::pattern::Slope;
use crate::syntax::Punct;

/// Reads `slope <direction>` or `slope { [point_at] V [, low, high] [altitude V [, low, high]] }`.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Pattern> {
    let keyword = vm.next()?;
    let mut slope = Slope { direction: DVec3::ZERO, point_at: false, range: [0.0; 2], altitude: None };
    let ((), place) = vm.located(|vm| {
        if vm.peek()?.kind != TokenKind::Punct(Punct::OpenBrace) {
            slope.direction = vm.read_vector()?;
            return Ok(());
        }
        let block = vm.open(keyword)?;
        slope.point_at = vm.accept(Word::PointAt)?;
        (slope.direction, slope.range) = directed(vm)?;
        if vm.accept(Word::Altitude)? {
            if slope.point_at {
                let fault = vm.error(vm.last, "`altitude` cannot be used with `point_at`");
                return Err(fault.help("with `point_at` only the direction of the surface counts"));
            }
            vm.note_experimental(Experimental::Slope);
            slope.altitude = Some(directed(vm)?);
        }
        vm.close(block)?;
        Ok(())
    })?;
    let altitude = slope.altitude.map_or(DVec3::ZERO, |(altitude, _)| altitude);
    if !slope.point_at && slope.direction == DVec3::ZERO && altitude == DVec3::ZERO {
        return Err(vm
            .error(place, "this direction has no length")
            .help("give the direction slopes are measured against, such as `y`"));
    }
    Ok(Pattern::Slope(Box::new(slope)))
}

/// Reads a direction, whose length is its weight, and its range.
fn directed(vm: &mut Vm<'_>) -> Result<(DVec3, [f64; 2])> {
    let direction = vm.read_vector()?;
    let mut range = [0.0; 2];
    for end in &mut range {
        vm.comma()?;
        if !vm.at_number()? {
            break;
        }
        *end = vm.read_float()?;
    }
    if range[0] == range[1] && range[0] != 0.0 {
        vm.warn(vm.last, "this range is empty", "it is not used; give a low and a high end");
    }
    Ok((direction, range))
}
