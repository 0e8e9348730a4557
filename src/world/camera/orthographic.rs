//! `orthographic`: parallel rays.

use super::{Film, Frame, Projected};
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
        let Frame { location, right, up, direction } = self.frame;
        let origin = location + film.x * right + film.y * up;
        Projected { ray: Ray::new(origin, direction), parameters: film }
    }
}
