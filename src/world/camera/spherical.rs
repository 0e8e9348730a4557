//! `spherical`: longitude across, latitude upwards.

use super::{Film, Frame, Projected};
use crate::math::{DVec2, DVec3};
use crate::world::Ray;

/// Film coordinates are longitude and latitude.
#[derive(Clone, Debug)]
pub struct Spherical {
    frame: Frame,
    /// Angles across and upwards, in radians.
    angle: DVec2,
}

impl Spherical {
    /// A camera seeing `horizontal` by `vertical` degrees.
    pub fn new(frame: &Frame, horizontal: f64, vertical: f64) -> Self {
        Self { frame: *frame, angle: DVec2::new(horizontal.to_radians(), vertical.to_radians()) }
    }

    /// Where all rays start.
    pub(super) fn eye(&self) -> DVec3 {
        self.frame.location
    }

    /// The direction turned up about `right`, then around `up`.
    pub fn project(&self, film: Film) -> Projected {
        let parameters = film * self.angle;
        let raised = turn(self.frame.direction, self.frame.right, -parameters.y);
        let direction = turn(raised, self.frame.up, parameters.x);
        Projected { ray: Ray::new(self.frame.location, direction), parameters }
    }
}

/// `v` turned right-handedly about `axis`; unturned about a zero axis.
fn turn(v: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    let axis = axis.normalize_or_zero();
    let (sin, cos) = angle.sin_cos();
    v * cos + axis.cross(v) * sin + axis * axis.dot(v) * (1.0 - cos)
}
