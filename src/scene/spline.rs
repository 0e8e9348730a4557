//! `spline { … }` (docs/spec/language.md 5).

pub use crate::math::spline::SplineKind;

/// A spline through up to five components.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    /// How points are joined.
    pub kind: SplineKind,
    /// Sorted by key, at least one.
    pub points: Vec<(f64, [f64; 5])>,
    /// Components in use, 2 … 5.
    pub size: usize,
}
