//! What media do at a point.

use std::ops::{Add, Mul, Range};

use super::intervals::Interval;
use super::{March, transmittance};
use crate::math::color::FourRgb;
use crate::math::{DVec3, Lanes, Rgb};
use crate::render::trace::Tracer;
use crate::world::{Media, Ray};

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

    /// Adds a part of an interval behind those before, which dim it; `share` is the part's.
    #[inline]
    pub(super) fn add_behind(&mut self, part: Self, share: f32) {
        self.source += part.source * share * transmittance(self.depth);
        self.depth += part.depth * share;
    }

    /// The same over a length.
    #[inline]
    pub(super) fn scaled(self, length: f64) -> Self {
        self * length as f32
    }
}

impl Add for Sample {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { source: self.source + other.source, depth: self.depth + other.depth }
    }
}

impl Mul<f32> for Sample {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f32) -> Self {
        Self { source: self.source * factor, depth: self.depth * factor }
    }
}

/// What media do over a unit at a point but for lamps, and what they scatter of these.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mixture {
    unlit: Sample,
    scattered: Rgb,
}

/// The same at four points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mixtures {
    source: FourRgb,
    depth: FourRgb,
    scattered: FourRgb,
}

impl Mixtures {
    /// The same four times.
    fn all(Mixture { unlit: Sample { source, depth }, scattered }: Mixture) -> Self {
        Self { source: FourRgb::all(source), depth: FourRgb::all(depth), scattered: FourRgb::all(scattered) }
    }

    /// One of them.
    #[inline]
    pub(super) fn get(&self, lane: usize) -> Mixture {
        Mixture { unlit: self.unlit(lane), scattered: self.scattered.get(lane) }
    }

    /// One of them without lamps.
    #[inline]
    pub(super) fn unlit(&self, lane: usize) -> Sample {
        Sample { source: self.source.get(lane), depth: self.depth.get(lane) }
    }
}

/// What media do over a unit at a point but for lamps, and what they scatter of these.
fn mixture(media: &[&Media], point: DVec3) -> Mixture {
    let (mut unlit, mut scattered) = (Sample::NOTHING, Rgb::ZERO);
    for media in media {
        let density = media.density.at(point);
        unlit.source += density * media.emission;
        unlit.depth += density * media.extinction;
        scattered += density * media.scattering;
    }
    Mixture { unlit, scattered }
}

/// The places of the first four of samples with these numbers, and how many there are.
#[inline(always)]
pub(super) fn four_places(
    numbers: Range<u32>,
    mut place: impl FnMut(u32) -> f64,
) -> ([f64; Lanes::COUNT], usize) {
    let (mut places, mut taken) = ([0.0; Lanes::COUNT], 0);
    for (at, number) in places.iter_mut().zip(numbers) {
        *at = place(number);
        taken += 1;
    }
    (places, taken)
}

/// The points at up to four places of an interval, the last as often as it takes.
fn points(march: &March, interval: &Interval, places: &[f64]) -> [Lanes; 3] {
    let mut s = Lanes::splat(places[places.len() - 1]);
    for (lane, place) in s.0.iter_mut().zip(places) {
        *lane = *place;
    }
    s = s * interval.length + interval.start;
    let Ray { origin, direction, .. } = &march.stretch.ray;
    [s * direction.x + origin.x, s * direction.y + origin.y, s * direction.z + origin.z]
}

impl Tracer<'_> {
    /// What media do over a unit at distance `s` of a march; lamps count where `lit`. What is `known` needs not be
    /// found.
    pub(super) fn media_sample(
        &mut self,
        march: &March,
        s: f64,
        lit: bool,
        known: Option<&Mixture>,
    ) -> Sample {
        let point = march.stretch.ray.at(s);
        let Mixture { mut unlit, scattered } = match (known, march.uniform) {
            (Some(known), _) => *known,
            (None, Some(unlit)) => {
                self.statistics.media_samples += 1;
                Mixture { unlit, scattered: march.scattered }
            }
            (None, None) => {
                self.statistics.media_samples += 1;
                mixture(&march.stretch.media, point)
            }
        };
        if lit && march.scatters && scattered != Rgb::ZERO {
            unlit.source += scattered * self.lamps(march, point, s);
        }
        unlit
    }

    /// What media do over a unit at one to four places of an interval.
    pub(super) fn media_mixtures(&mut self, march: &March, interval: &Interval, places: &[f64]) -> Mixtures {
        self.statistics.media_samples += places.len() as u64;
        if let [place] = *places {
            return Mixtures::all(mixture(&march.stretch.media, march.stretch.ray.at(interval.at(place))));
        }
        let mut sums = Mixtures { source: FourRgb::ZERO, depth: FourRgb::ZERO, scattered: FourRgb::ZERO };
        let point = points(march, interval, places);
        for media in &march.stretch.media {
            let density = media.density.four(&point);
            sums.source.add(&density, media.emission);
            sums.depth.add(&density, media.extinction);
            if march.scatters {
                sums.scattered.add(&density, media.scattering);
            }
        }
        sums
    }

    /// The optical depths of a unit at one to four places of an interval.
    pub(super) fn media_depths(&mut self, march: &March, interval: &Interval, places: &[f64]) -> FourRgb {
        self.statistics.media_samples += places.len() as u64;
        if let [place] = *places {
            let point = march.stretch.ray.at(interval.at(place));
            let media = &march.stretch.media;
            return FourRgb::all(media.iter().map(|media| media.density.at(point) * media.extinction).sum());
        }
        let mut sums = FourRgb::ZERO;
        let point = points(march, interval, places);
        for media in &march.stretch.media {
            if media.dims() {
                sums.add(&media.density.four(&point), media.extinction);
            }
        }
        sums
    }
}
