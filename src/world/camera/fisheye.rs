//! `fisheye`: the angle to the axis grows evenly with the distance from the middle.

use std::f64::consts::TAU;

use super::{Film, Frame, Projected};
use crate::math::{DVec2, DVec3};

/// A disc of picture; its edge is half the angle away from the axis.
#[derive(Clone, Debug)]
pub struct Fisheye {
    frame: Frame,
    /// Twice the lengths of right and up: film to disc.
    scale: DVec2,
    /// Angle at the edge in radians.
    edge: f64,
}

impl Fisheye {
    /// A camera seeing `angle` degrees across its disc.
    pub fn new(frame: &Frame, angle: f64) -> Self {
        Self {
            frame: frame.unit(),
            scale: 2.0 * DVec2::new(frame.right.length(), frame.up.length()),
            edge: angle.to_radians() / 2.0,
        }
    }

    /// Where all rays start.
    pub(super) fn eye(&self) -> DVec3 {
        self.frame.location
    }

    /// The ray of a place on the disc; `None` outside it.
    pub fn project(&self, film: Film) -> Option<Projected> {
        let place = film * self.scale;
        let radius = place.length();
        (radius <= 1.0).then(|| polar(&self.frame, place, radius * self.edge))
    }
}

/// The ray `theta` radians off the axis, towards `place` on the disc.
pub(super) fn polar(frame: &Frame, place: DVec2, theta: f64) -> Projected {
    let mut phi = if place == DVec2::ZERO { 0.0 } else { place.y.atan2(place.x) };
    // From straight down all around, which only the bumps of the camera can tell.
    if place.x < 0.0 && place.y < 0.0 {
        phi += TAU;
    }
    let (sin, cos) = theta.sin_cos();
    let ray = frame.ray(sin * phi.cos(), sin * phi.sin(), cos);
    Projected { ray, parameters: DVec2::new(phi, theta) }
}
