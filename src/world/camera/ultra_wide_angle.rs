//! `ultra_wide_angle`: like fisheye, on a rectangle.

use super::{Film, Frame, Projected};
use crate::math::{DVec2, DVec3};

/// Film coordinates are angles.
#[derive(Clone, Debug)]
pub struct UltraWideAngle {
    frame: Frame,
    /// Horizontal and vertical angle across the film, in radians.
    angle: DVec2,
}

impl UltraWideAngle {
    /// A camera seeing `angle` degrees across its width; the height follows from up and right.
    pub fn new(frame: &Frame, angle: f64) -> Self {
        let across = angle.to_radians();
        let angle = DVec2::new(across, across * frame.up.length() / frame.right.length());
        Self { frame: frame.unit(), angle }
    }

    /// Where all rays start.
    pub(super) fn eye(&self) -> DVec3 {
        self.frame.location
    }

    /// The ray `sin A R + sin B U + cos A cos B D`.
    pub fn project(&self, film: Film) -> Projected {
        let parameters = film * self.angle;
        let (a, b) = (parameters.x.sin_cos(), parameters.y.sin_cos());
        Projected { ray: self.frame.ray(a.0, b.0, a.1 * b.1), parameters }
    }
}
