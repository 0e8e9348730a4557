//! How `lathe` and `prism` join their points.

use crate::interp::{Result, Vm, Word};
use crate::scene::shape::ContourSpline;

/// The spline a word names.
pub(super) fn spline(word: Word) -> Option<ContourSpline> {
    Some(match word {
        Word::LinearSpline => ContourSpline::Linear,
        Word::QuadraticSpline => ContourSpline::Quadratic,
        Word::CubicSpline => ContourSpline::Cubic,
        Word::BezierSpline => ContourSpline::Bezier,
        _ => return None,
    })
}

/// Reads a number of points: `least` ones for the four splines, whole fours for Bézier curves.
pub(super) fn count(vm: &mut Vm<'_>, what: &str, spline: ContourSpline, least: [i32; 4]) -> Result<usize> {
    let (count, place) = vm.located(Vm::read_int)?;
    let (name, least) = match spline {
        ContourSpline::Linear => ("linear_spline", least[0]),
        ContourSpline::Quadratic => ("quadratic_spline", least[1]),
        ContourSpline::Cubic => ("cubic_spline", least[2]),
        ContourSpline::Bezier => ("bezier_spline", least[3]),
    };
    if count < least {
        return Err(
            vm.error(place, format!("a {what} with a `{name}` needs at least {least} points, not {count}"))
        );
    }
    if spline == ContourSpline::Bezier && count % 4 != 0 {
        return Err(vm
            .error(place, format!("{count} is not a multiple of 4"))
            .help("each piece of a `bezier_spline` has four points of its own"));
    }
    Ok(count as usize)
}
