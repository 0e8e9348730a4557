//! `orthographic`: parallel rays.

use super::{Film, Frame, Projected};
use crate::math::{DVec3, Lanes};
use crate::world::Ray;

/// Rays along the direction from everywhere on a rectangle.
#[derive(Clone, Debug)]
pub struct Orthographic {
    /// The camera's vectors.
    pub frame: Frame,
}

impl Orthographic {
    /// The ray along `D` from `L + x R + y U`.
    pub fn project(&self, film: Film) -> Projected {
        Projected { ray: Ray::new(self.origin(film), self.frame.direction), parameters: film }
    }

    /// Where the ray through a place on the film starts.
    #[inline]
    pub fn origin(&self, film: Film) -> DVec3 {
        let Frame { location, right, up, .. } = self.frame;
        location + film.x * right + film.y * up
    }

    /// The same of four.
    #[inline(always)]
    pub fn origins(&self, x: Lanes, y: Lanes) -> [Lanes; 3] {
        let Frame { location, right, up, .. } = self.frame;
        let along = |location: f64, right: f64, up: f64| x * right + location + y * up;
        [along(location.x, right.x, up.x), along(location.y, right.y, up.y), along(location.z, right.z, up.z)]
    }

    /// The direction of all rays, unit.
    #[inline]
    pub fn direction(&self) -> DVec3 {
        self.frame.direction.normalize_or_zero()
    }
}
