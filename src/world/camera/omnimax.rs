//! `omnimax`: a fisheye for domed screens.

use super::fisheye::polar;
use super::{Film, Frame, Projected};
use crate::math::{DVec2, DVec3};

/// Width to height from which the picture is cut at the top instead of at the sides.
const WIDEST: f64 = 1.283_458;

/// A fisheye whose lower edge is cut 45 degrees below the axis.
#[derive(Clone, Debug)]
pub struct Omnimax {
    frame: Frame,
    /// Width to height.
    aspect: f64,
}

impl Omnimax {
    /// A camera; `angle` doesn't matter to it.
    pub fn new(frame: &Frame) -> Self {
        Self { frame: frame.unit(), aspect: frame.right.length() / frame.up.length() }
    }

    /// Where all rays start.
    pub(super) fn eye(&self) -> DVec3 {
        self.frame.location
    }

    /// The ray of a place on the dome; `None` outside its picture.
    pub fn project(&self, film: Film) -> Option<Projected> {
        let DVec2 { x, y } = 2.0 * film;
        let q = self.aspect;
        let place = if q > WIDEST {
            DVec2::new(x * q / WIDEST, (y - 1.0) / WIDEST + 1.0)
        } else if q > 1.0 {
            DVec2::new(x, (y - 1.0) / q + 1.0)
        } else {
            DVec2::new(x, y / q)
        };
        let r = place.length();
        if r > 1.0 {
            return None;
        }
        let theta = 1.411_269 * r - 0.094_39 * r.powi(3) + 0.256_74 * r.powi(5);
        let projected = polar(&self.frame, place, theta);
        let below = projected.parameters.x.sin() * theta.sin() < 135f64.to_radians().tan() * theta.cos();
        (!below).then_some(projected)
    }
}
