//! What media do at a point.

use std::ops::{Add, Mul};

use super::March;
use crate::math::{DVec3, Rgb};
use crate::render::trace::Tracer;
use crate::world::Media;

/// Light that media send to the eye, and the optical depth: per unit of length, or of an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    /// Emitted and scattered light.
    pub(super) source: Rgb,
    /// Absorption and loss by scattering.
    pub(super) depth: Rgb,
}

impl Sample {
    /// Clear space.
    pub(super) const NOTHING: Self = Self { source: Rgb::ZERO, depth: Rgb::ZERO };

    /// The same over a length.
    pub(super) fn scaled(self, length: f64) -> Self {
        self * length as f32
    }
}

impl Add for Sample {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { source: self.source + other.source, depth: self.depth + other.depth }
    }
}

impl Mul<f32> for Sample {
    type Output = Self;

    fn mul(self, factor: f32) -> Self {
        Self { source: self.source * factor, depth: self.depth * factor }
    }
}

/// What media do over a unit at a point but for lamps, and what they scatter of these.
fn mixture(media: &[&Media], point: DVec3) -> (Sample, Rgb) {
    let mut sum = Sample::NOTHING;
    let mut scattered = Rgb::ZERO;
    for media in media {
        let density = media.density.at(point);
        sum.source += density * media.emission;
        sum.depth += density * media.extinction;
        scattered += density * media.scattering;
    }
    (sum, scattered)
}

impl Tracer<'_> {
    /// What media do over a unit at distance `s` of a march; lamps count where `lit`.
    pub(super) fn media_sample(&mut self, march: &March, s: f64, lit: bool) -> Sample {
        self.statistics.media_samples += 1;
        let point = march.stretch.ray.at(s);
        let (mut sum, scattered) = match march.uniform {
            Some(uniform) => (uniform, march.scattered),
            None => mixture(&march.stretch.media, point),
        };
        if lit && march.scatters && scattered != Rgb::ZERO {
            sum.source += scattered * self.lamps(march, point, s);
        }
        sum
    }

    /// The optical depth of a unit at distance `s` of a march.
    pub(super) fn media_depth(&mut self, march: &March, s: f64) -> Rgb {
        self.statistics.media_samples += 1;
        let point = march.stretch.ray.at(s);
        march.stretch.media.iter().map(|media| media.density.at(point) * media.extinction).sum()
    }
}
