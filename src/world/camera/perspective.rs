//! `perspective`: straight lines stay straight.

use super::{Film, Frame, Projected};
use crate::math::{DVec3, Lanes};

/// A pinhole camera; the field of view comes from the lengths of the vectors.
#[derive(Clone, Debug)]
pub struct Perspective {
    /// The camera's vectors.
    pub frame: Frame,
}

impl Perspective {
    /// The ray `D + x R + y U` from the eye.
    #[inline]
    pub fn project(&self, film: Film) -> Projected {
        Projected { ray: self.frame.ray(film.x, film.y, 1.0), parameters: film }
    }

    /// Four directions, of any length.
    #[inline(always)]
    pub fn directions(&self, x: Lanes, y: Lanes) -> [Lanes; 3] {
        let Frame { right, up, direction, .. } = self.frame;
        let along = |right: f64, up: f64, direction: f64| x * right + y * up + direction;
        [
            along(right.x, up.x, direction.x),
            along(right.y, up.y, direction.y),
            along(right.z, up.z, direction.z),
        ]
    }

    /// The ray's direction alone, of any length.
    #[inline]
    pub fn direction(&self, film: Film) -> DVec3 {
        self.project(film).ray.direction
    }
}
