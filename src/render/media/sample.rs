//! What media do at a point.

use std::ops::{Add, Mul};

use super::March;
use crate::math::{DVec3, Rgb};
use crate::render::shadow::Target;
use crate::render::trace::Tracer;
use crate::world::hit::Among;
use crate::world::screen::{SHUT, sift};
use crate::world::{Intersection, Media};

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

    /// The light of lamps at a point of a march, each weighted by its share that goes to the eye.
    fn lamps(&mut self, march: &March, point: DVec3, s: f64) -> Rgb {
        let stretch = march.stretch;
        let surface = Intersection::in_space(point);
        let target = Target { surface: &surface, hit: None, inside: stretch.inside, among: None };
        let mut sum = Rgb::ZERO;
        for beam in march.beams.iter().filter(|beam| beam.reach.min <= s && s <= beam.reach.max) {
            let light = &self.world.lights[beam.light as usize];
            let incident = light.reaching(point);
            if incident.is_dark() {
                self.statistics.lights_dark += 1;
                continue;
            }
            let cosine = stretch.ray.direction.dot(incident.direction);
            let shares: f32 = stretch.media.iter().map(|media| media.phase.share(cosine)).sum();
            let share = shares / stretch.media.len() as f32;
            if share != 0.0 {
                let Some(span) = beam.among.clone() else {
                    sum += share * self.unblocked(&target, beam.light, &incident);
                    continue;
                };
                let between = march.between[span].iter().filter(|between| between.shade.contains(s));
                if light.area.is_some() {
                    let mut screens = std::mem::take(&mut self.screens);
                    screens.clear();
                    screens.extend(between.map(|between| between.screen));
                    let target = Target { among: Some(Among::Screens(&screens)), ..target };
                    sum += share * self.unblocked(&target, beam.light, &incident);
                    self.screens = screens;
                    continue;
                }
                let mut near = std::mem::take(&mut self.near);
                let seen = between.map(|between| (&between.screen, between.view.as_ref()));
                let verdict = sift(seen, point - light.location, &mut near);
                if verdict == SHUT && self.quality.shadows {
                    self.statistics.shadow_rays += 1;
                } else {
                    let target = Target { among: Some(Among::Near(&near)), ..target };
                    sum += share * self.unblocked(&target, beam.light, &incident);
                }
                self.near = near;
            }
        }
        sum
    }
}
