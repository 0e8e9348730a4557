//! `cone { <base>, radius, <cap>, radius [open] }` and `cylinder { <base>, <cap>, radius [open] }`
//! (docs/spec/primitives.md 3.4 and 3.5).

use crate::interp::{Result, Vm, Word};
use crate::math::DVec3;
use crate::scene::{Shape, shape::Cone};
use crate::source::Span;

/// Ends nearer than this share of their coordinates are the same point. POV-Ray's measure is 1e-10,
/// whatever the size of the scene.
const LEAST_LENGTH: f64 = 4.0 * f64::EPSILON;

/// Reads the parameters of a `cone`.
pub(super) fn cone(vm: &mut Vm<'_>) -> Result<Shape> {
    let start = vm.here()?;
    let base = vm.read_vector()?;
    vm.comma()?;
    let base_radius = super::radius(vm, "cone")?;
    vm.comma()?;
    let cap = vm.read_vector()?;
    check_length(vm, "cone", base, cap, start)?;
    vm.comma()?;
    let cap_radius = super::radius(vm, "cone")?;
    let open = vm.accept(Word::Open)?;
    Ok(Shape::Cone(Box::new(Cone { base, base_radius, cap, cap_radius, open })))
}

/// Reads the parameters of a `cylinder`.
pub(super) fn cylinder(vm: &mut Vm<'_>) -> Result<Shape> {
    let start = vm.here()?;
    let base = vm.read_vector()?;
    vm.comma()?;
    let cap = vm.read_vector()?;
    check_length(vm, "cylinder", base, cap, start)?;
    vm.comma()?;
    let radius = super::radius(vm, "cylinder")?;
    let open = vm.accept(Word::Open)?;
    Ok(Shape::Cylinder(Box::new(Cone { base, base_radius: radius, cap, cap_radius: radius, open })))
}

/// Refuses ends that coincide.
pub(super) fn check_length(vm: &Vm<'_>, what: &str, base: DVec3, cap: DVec3, start: Span) -> Result<()> {
    if base.distance(cap) > LEAST_LENGTH * base.abs().max(cap.abs()).max_element() {
        return Ok(());
    }
    let place = start.to(vm.last);
    Err(vm
        .error(place, format!("both ends of this {what} are the same point"))
        .help(format!("a {what} needs two different end points; for a flat circle use `disc`")))
}
