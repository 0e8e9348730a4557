//! `boxed`, `cylindrical`, `planar`, `spherical`: 1 in the middle, 0 from distance 1 on
//! (docs/spec/patterns-textures.md 2.2).

use crate::math::{DVec3, Lanes};

#[inline(always)]
pub(super) fn fall(distance: f64) -> f64 {
    if distance < 0.0 {
        1.0
    } else if distance > 1.0 {
        0.0
    } else {
        1.0 - distance
    }
}

/// Falls towards the faces of a cube.
pub(super) fn boxed(p: DVec3) -> f64 {
    fall(p.abs().max_element())
}

/// [`boxed`] at four points.
#[inline(always)]
pub(super) fn boxed_at_four([x, y, z]: &[Lanes; 3]) -> Lanes {
    x.abs().greater(y.abs().greater(z.abs())).map(fall)
}

/// Falls away from the y axis.
pub(super) fn cylindrical(p: DVec3) -> f64 {
    fall((p.x * p.x + p.z * p.z).sqrt())
}

/// [`cylindrical`] at four points.
#[inline(always)]
pub(super) fn cylindrical_at_four([x, _, z]: &[Lanes; 3]) -> Lanes {
    (*x * *x + *z * *z).sqrt().map(fall)
}

/// Falls away from the x-z plane.
pub(super) fn planar(p: DVec3) -> f64 {
    fall(p.y.abs())
}

/// Falls away from the origin.
pub(super) fn spherical(p: DVec3) -> f64 {
    fall((p.x * p.x + p.y * p.y + p.z * p.z).sqrt())
}

/// [`spherical`] at four points.
#[inline(always)]
pub(super) fn spherical_at_four(point: &[Lanes; 3]) -> Lanes {
    Lanes::dot(point, point).sqrt().map(fall)
}
