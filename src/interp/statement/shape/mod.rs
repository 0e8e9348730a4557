//! The parameters of every shape, one file to a keyword (docs/spec/language.md 6.5).
//!
//! A reader takes what stands between the opening brace and the object modifiers.

mod bicubic_patch;
mod blob;
mod box_;
mod cone;
mod container;
mod contour;
mod csg;
mod disc;
mod height_field;
mod isosurface;
mod julia_fractal;
mod lathe;
mod mesh;
mod mesh2;
mod ovus;
mod parametric;
mod plane;
mod poly;
mod polygon;
mod prism;
mod quadric;
mod sor;
mod sphere;
mod sphere_sweep;
mod superellipsoid;
mod text;
mod torus;
mod triangle;

use std::sync::Arc;

use super::super::{Block, Result, Vm, Word};
use crate::math::DVec2;
use crate::scene::object::ObjectFlags;
use crate::scene::{Function, Shape};
use crate::source::Span;

/// Whether a word begins a statement that makes an object with a shape of its own.
pub(super) fn is_shape(word: Word) -> bool {
    use Word::*;
    matches!(
        word,
        BicubicPatch
            | Blob
            | Box
            | Composite
            | Cone
            | Cubic
            | Cylinder
            | Difference
            | Disc
            | HeightField
            | Intersection
            | Isosurface
            | JuliaFractal
            | Lathe
            | Merge
            | Mesh
            | Mesh2
            | Ovus
            | Parametric
            | Plane
            | Poly
            | Polygon
            | Polynomial
            | Prism
            | Quadric
            | Quartic
            | SmoothTriangle
            | Sor
            | Sphere
            | SphereSweep
            | Superellipsoid
            | Text
            | Torus
            | Triangle
            | Union
    )
}

/// Reads the parameters of the shape whose block was opened.
pub(super) fn read(vm: &mut Vm<'_>, block: &Block) -> Result<(Shape, ObjectFlags)> {
    let shape = match block.keyword {
        Word::BicubicPatch => bicubic_patch::read(vm, block),
        Word::Blob => blob::read(vm, block),
        Word::Box => box_::read(vm),
        Word::Cone => cone::cone(vm),
        Word::Cubic => poly::fixed(vm, 3),
        Word::Cylinder => cone::cylinder(vm),
        Word::Disc => disc::read(vm),
        Word::HeightField => height_field::read(vm),
        Word::Isosurface => isosurface::read(vm),
        Word::JuliaFractal => julia_fractal::read(vm, block),
        Word::Lathe => lathe::read(vm),
        Word::Mesh => mesh::read(vm, block),
        Word::Mesh2 => mesh2::read(vm, block),
        Word::Ovus => ovus::read(vm),
        Word::Parametric => parametric::read(vm),
        Word::Plane => plane::read(vm),
        Word::Poly => poly::poly(vm),
        Word::Polygon => polygon::read(vm),
        Word::Polynomial => poly::polynomial(vm),
        Word::Prism => prism::read(vm),
        Word::Quadric => quadric::read(vm),
        Word::Quartic => poly::fixed(vm, 4),
        Word::SmoothTriangle => triangle::smooth_triangle(vm),
        Word::Sor => sor::read(vm),
        Word::Sphere => sphere::read(vm),
        Word::SphereSweep => sphere_sweep::read(vm),
        Word::Superellipsoid => superellipsoid::read(vm),
        Word::Text => text::read(vm),
        Word::Torus => torus::read(vm),
        Word::Triangle => triangle::triangle(vm),
        _ => return csg::read(vm, block),
    };
    Ok((shape?, ObjectFlags::empty()))
}

/// Reads `count` entries with commas before, between and after them, where written.
fn points<'v, T>(
    vm: &mut Vm<'v>,
    count: usize,
    mut read: impl FnMut(&mut Vm<'v>) -> Result<T>,
) -> Result<Vec<T>> {
    let mut points = Vec::with_capacity(reserve(count));
    for _ in 0..count {
        vm.comma()?;
        points.push(read(vm)?);
    }
    vm.comma()?;
    Ok(points)
}

/// Reads a radius. POV-Ray takes negative ones as they come and says nothing.
fn radius(vm: &mut Vm<'_>, what: &str) -> Result<f64> {
    let (radius, place) = vm.located(Vm::read_float)?;
    if radius < 0.0 {
        let help = format!("POV-Ray accepts it and says nothing; did you mean `{}`?", -radius);
        vm.warn(place, format!("the radius of this {what} is negative"), &help);
    }
    check_finite(vm, &[radius], "radius", place)?;
    Ok(radius)
}

/// Refuses coefficients and the like that are infinite or no number.
fn check_finite(vm: &Vm<'_>, numbers: &[f64], what: &str, place: Span) -> Result<()> {
    match numbers.iter().find(|number| !number.is_finite()) {
        None => Ok(()),
        Some(number) => Err(vm
            .error(place, format!("a {what} cannot be {}", if number.is_nan() { "NaN" } else { "infinite" }))
            .help("no surface has such a number in its equation: look for a division by something tiny")),
    }
}

/// How much to reserve for a list that claims to have `count` entries: it may have fewer, and room that nothing is
/// written to costs nothing.
fn reserve(count: usize) -> usize {
    count.min(1 << 20)
}

/// Reads `N` texture coordinates.
fn uvs<const N: usize>(vm: &mut Vm<'_>) -> Result<[DVec2; N]> {
    let mut uvs = [DVec2::ZERO; N];
    for (index, uv) in uvs.iter_mut().enumerate() {
        if index > 0 {
            vm.comma()?;
        }
        *uv = vm.read_uv()?;
    }
    Ok(uvs)
}

/// Reads `function { … }` of an isosurface or a parametric surface: parameters are x, y, z.
fn function(vm: &mut Vm<'_>) -> Result<Arc<Function>> {
    match vm.peek_word()? {
        Some(Word::Function) => vm.read_plain_function(),
        _ => Err(vm.expected("`function { … }`")),
    }
}
