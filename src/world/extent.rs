//! Where things are in space, inverted ones too.

use crate::math::{Bounds, DVec3, Transform};

/// The part of space where a member is interesting: all its surface is in the box, and outside
/// of it everything is inside, or everything outside, the member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The box.
    pub bounds: Bounds,
    /// Whether points beyond the box are inside the member.
    pub beyond: bool,
}

impl Extent {
    /// Of the part common to all.
    pub fn intersection(parts: impl Iterator<Item = Self> + Clone) -> Self {
        // Outside of the box of any part with nothing beyond, nothing is common.
        let limiting = parts.clone().filter(|part| !part.beyond);
        if limiting.clone().next().is_some() {
            let bounds = limiting.fold(Bounds::ALL, |all, part| all.intersection(part.bounds));
            Self { bounds, beyond: false }
        } else {
            Self { bounds: around(parts), beyond: true }
        }
    }

    /// Of everything that is in any.
    pub fn union(parts: impl Iterator<Item = Self> + Clone) -> Self {
        Self { beyond: parts.clone().any(|part| part.beyond), bounds: around(parts) }
    }
}

fn around(parts: impl Iterator<Item = Extent>) -> Bounds {
    parts.fold(Bounds::EMPTY, |all, part| all.union(part.bounds))
}

/// The box of what is below a plane, unbounded on all sides but one; components of the normal up
/// to `flat` count as zero.
pub fn half_space(normal: DVec3, distance: f64, transform: Option<&Transform>, flat: f64) -> Bounds {
    let (normal, distance) = match transform {
        Some(transform) => {
            let point = transform.point(normal * distance);
            let normal = transform.normal(normal).normalize_or_zero();
            (normal, normal.dot(point))
        }
        None => (normal, distance),
    };
    let mut bounds = Bounds::ALL;
    let axis = normal.abs().max_position();
    let axial = (0..3).all(|other| other == axis || normal[other].abs() <= flat);
    if axial && normal[axis] > 0.0 {
        bounds.max[axis] = distance / normal[axis];
    } else if axial && normal[axis] < 0.0 {
        bounds.min[axis] = distance / normal[axis];
    }
    bounds
}

/// A slightly larger box, so that points rounded onto the surface are never outside of it.
pub fn around_rounding(bounds: Bounds) -> Bounds {
    let margin = |corner: DVec3, other: DVec3| {
        let finite = |x: f64| if x.is_finite() { x.abs() } else { 0.0 };
        let size = DVec3::new(
            finite(corner.x).max(finite(other.x)),
            finite(corner.y).max(finite(other.y)),
            finite(corner.z).max(finite(other.z)),
        );
        size * (16.0 * f64::EPSILON)
    };
    if bounds.is_empty() {
        return bounds;
    }
    let margin = margin(bounds.min, bounds.max);
    Bounds { min: bounds.min - margin, max: bounds.max + margin }
}
