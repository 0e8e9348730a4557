//! `panoramic`: 180 degrees around, straight verticals.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Film, Frame, Projected};
use crate::math::DVec2;

/// The tangent taken straight up and down.
const STEEP: f64 = 2e10;

/// Angles across, tangents of angles upwards.
#[derive(Clone, Debug)]
pub struct Panoramic {
    /// The camera's vectors.
    pub frame: Frame,
}

impl Panoramic {
    /// The ray `cos A R + tan B U + sin A D`.
    pub fn project(&self, film: Film) -> Projected {
        let (a, b) = (PI * (0.5 - film.x), PI * film.y);
        let rise = if (b.abs() - FRAC_PI_2).abs() < 1e-10 { STEEP.copysign(b) } else { b.tan() };
        Projected { ray: self.frame.ray(a.cos(), rise, a.sin()), parameters: DVec2::new(a, b) }
    }
}
