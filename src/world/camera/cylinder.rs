//! `cylinder 1` … `cylinder 4`: the film is rolled around an axis of the picture.

use super::{Film, Frame, Projected};
use crate::math::{DVec2, DVec3};
use crate::world::Ray;

/// A cylindrical film, seen from a point or from an axis.
#[derive(Clone, Debug)]
pub struct Cylinder {
    frame: Frame,
    /// Whether the axis stands upright: the picture is rolled from left to right.
    upright: bool,
    /// Whether the eye moves along the axis.
    moving: bool,
    /// Angle around the axis in radians.
    angle: f64,
    /// Extent along the axis.
    extent: f64,
}

impl Cylinder {
    /// `cylinder kind`, `kind` 1 … 4: 1 and 3 are upright, 3 and 4 have a moving eye; `angle` in degrees.
    pub fn new(frame: &Frame, kind: u32, angle: f64) -> Self {
        let upright = kind == 1 || kind == 3;
        Self {
            frame: frame.unit(),
            upright,
            moving: kind >= 3,
            angle: angle.to_radians(),
            extent: if upright { frame.up.length() } else { frame.right.length() },
        }
    }

    /// Where all rays start, if they start at one point.
    pub(super) fn eye(&self) -> Option<DVec3> {
        (!self.moving).then_some(self.frame.location)
    }

    /// The ray at an angle around the axis and at a height along it.
    pub fn project(&self, film: Film) -> Projected {
        let Frame { location, right, up, direction } = self.frame;
        let (around, along, turn, axis) =
            if self.upright { (film.x, film.y, right, up) } else { (film.y, film.x, up, right) };
        let (angle, height) = (around * self.angle, along * self.extent);
        let (sin, cos) = angle.sin_cos();
        let (flat, shift) = (sin * turn + cos * direction, height * axis);
        let ray =
            if self.moving { Ray::new(location + shift, flat) } else { Ray::new(location, flat + shift) };
        let parameters = if self.upright { DVec2::new(angle, height) } else { DVec2::new(height, angle) };
        Projected { ray, parameters }
    }
}
