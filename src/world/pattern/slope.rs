//! `slope` and `aoi`: patterns of the surface (docs/spec/patterns-textures.md 2.8).

use std::f64::consts::PI;

use crate::math::DVec3;
use crate::math::noise::EPSILON;
use crate::world::sample::Sample;

/// `slope`.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    /// Where the surface should look.
    pub target: Target,
    /// Slopes stretched to 0 … 1; equal ends leave them.
    pub range: [f64; 2],
    /// Shares of slope and altitude.
    pub weights: [f64; 2],
    /// Unit vector of the altitude, and altitudes stretched to 0 … 1.
    pub altitude: (DVec3, [f64; 2]),
}

/// Where the surface of a full slope looks.
#[derive(Clone, Copy, Debug)]
pub enum Target {
    /// In this direction, a unit vector.
    Direction(DVec3),
    /// From the hit to this point.
    Point(DVec3),
}

impl Slope {
    pub(super) fn value(&self, p: DVec3, sample: &Sample) -> f64 {
        if sample.normal == DVec3::ZERO {
            return 0.0;
        }
        let direction = match self.target {
            Target::Direction(direction) => direction,
            Target::Point(point) => (point - sample.position).normalize_or_zero(),
        };
        let along = sample.bent.dot(direction).clamp(-1.0, 1.0);
        let slope = stretch((along.asin() / PI * 2.0 + 1.0) * 0.5, self.range);
        let [slope_share, altitude_share] = self.weights;
        if altitude_share == 0.0 {
            return if slope == 1.0 { slope - EPSILON } else { wrap(slope) };
        }
        let (up, range) = self.altitude;
        let v = slope_share * slope + altitude_share * stretch(p.dot(up), range);
        if (1.0..1.0 + EPSILON).contains(&v) { v - EPSILON } else { wrap(v) }
    }
}

fn stretch(v: f64, [low, high]: [f64; 2]) -> f64 {
    if high - low == 0.0 { v } else { (v - low) / (high - low) }
}

fn wrap(v: f64) -> f64 {
    if v < 0.0 { 1.0 + v % 1.0 } else { v % 1.0 }
}

/// The angle between normal and ray, ½ … 1 on surfaces seen from the front.
pub(super) fn aoi(sample: &Sample) -> f64 {
    if sample.normal == DVec3::ZERO {
        return 0.0;
    }
    let normal = sample.bent.normalize_or_zero();
    normal.dot(sample.direction.normalize_or_zero()).clamp(-1.0, 1.0).acos() / PI
}
