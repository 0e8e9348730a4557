//! `ripples` and `waves`: rings around random sources (docs/spec/patterns-textures.md 2.2 and 4.2).

use std::sync::Arc;

use crate::math::DVec3;
use crate::math::noise::{WaveSource, cycle};

/// The sources, and the frequency and phase of the pattern, which enter the formula too.
#[derive(Clone, Debug)]
pub struct Ripples {
    /// At least one.
    pub sources: Arc<[WaveSource]>,
    /// As written in the pattern.
    pub frequency: f64,
    /// As written in the pattern.
    pub phase: f64,
}

impl Ripples {
    pub(super) fn ripples(&self, p: DVec3) -> f64 {
        let heights = self
            .sources
            .iter()
            .map(|source| cycle(distance(p - source.center) * self.frequency + self.phase));
        let sum: f64 = heights.sum();
        0.5 * (1.0 + sum / self.sources.len() as f64)
    }

    pub(super) fn waves(&self, p: DVec3) -> f64 {
        let heights = self.sources.iter().map(|source| {
            let f = source.frequency;
            cycle(distance(p - source.center) * self.frequency * f + self.phase) / f
        });
        let sum: f64 = heights.sum();
        0.2 * (2.5 + sum / self.sources.len() as f64)
    }

    /// The normal `n` at `p` bent by ripples of strength `amount`.
    pub(crate) fn ripple_normal(&self, p: DVec3, n: DVec3, amount: f64) -> DVec3 {
        self.bent(p, n, |length, _| cycle(length * self.frequency + self.phase) * amount)
    }

    /// The normal `n` at `p` bent by waves of strength `amount`.
    pub(crate) fn wave_normal(&self, p: DVec3, n: DVec3, amount: f64) -> DVec3 {
        self.bent(p, n, |length, f| cycle(length * self.frequency * f + self.phase) * amount / f)
    }

    fn bent(&self, p: DVec3, n: DVec3, strength: impl Fn(f64, f64) -> f64) -> DVec3 {
        let count = self.sources.len() as f64;
        self.sources.iter().fold(n, |n, source| {
            let d = p - source.center;
            let length = distance(d);
            n + strength(length, source.frequency) / (length * count) * d
        })
    }
}

/// Length of `d`; 1 at a source itself, where there is no direction.
fn distance(d: DVec3) -> f64 {
    let length = d.length();
    if length == 0.0 { 1.0 } else { length }
}
