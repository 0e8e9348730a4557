//! Normals: how bumps bend the surface (docs/spec/patterns-textures.md 4).

use std::sync::Arc;

use super::blend_map::{BlendMap, Pick};
use crate::math::noise::{vector_noise, vector_noise_scaled};
use crate::math::{DVec2, DVec3, tally};
use crate::world::image::ImageMap;
use crate::world::pattern::noise::{WRINKLES, dents};
use crate::world::pattern::{Formula, Pattern};
use crate::world::sample::Sample;
use crate::world::warp::Warps;

/// A normal block.
#[derive(Clone, Debug)]
pub struct Normal {
    /// How the surface is bent.
    pub kind: NormalKind,
    /// Height of the bumps.
    pub amount: f64,
    /// Distance of the probes.
    pub accuracy: f64,
    /// Transforms change the depth of the bumps.
    pub no_bump_scale: bool,
}

/// How a [`Normal`] bends the surface.
#[derive(Clone, Debug)]
pub enum NormalKind {
    /// By a formula of its own, or by the slopes of the pattern.
    Pattern(Pattern),
    /// By the slopes of the pattern's values seen through a map of heights and slopes.
    Slopes(Pattern, BlendMap<DVec2>),
    /// A pattern selects or blends normals.
    Normals(Pattern, BlendMap<Arc<Normal>>),
    /// `average`: the map's positions are weights.
    Average(Warps, BlendMap<Arc<Normal>>),
    /// `bump_map`.
    Bumps(Warps, Box<ImageMap>),
    /// Evaluated at `<u,v,0>`.
    UvMapped(Arc<Normal>),
}

/// The directions of the probes: a tetrahedron's corners.
const PROBES: [DVec3; 4] = [
    DVec3::new(0.942809041, -0.333333333, 0.0),
    DVec3::new(-0.471404521, -0.333333333, 0.816496581),
    DVec3::new(-0.471404521, -0.333333333, -0.816496581),
    DVec3::new(0.0, 1.0, 0.0),
];

impl Normal {
    /// Whether surfaces stay as they are: the bumps have no height.
    pub fn is_flat(&self) -> bool {
        let bumps = match &self.kind {
            NormalKind::Pattern(pattern) => !matches!(pattern.formula, Formula::Facets(_)),
            NormalKind::Slopes(..) | NormalKind::Bumps(..) => true,
            NormalKind::Normals(..) | NormalKind::Average(..) | NormalKind::UvMapped(_) => false,
        };
        bumps && self.amount == 0.0
    }

    /// The normal `n` of the sample's space, bent: the whole block, into the pattern's space and back.
    /// Unit unless `no_bump_scale` of this block or, as `raw`, of one around it.
    pub fn bend(&self, sample: &Sample, n: DVec3, raw: bool) -> DVec3 {
        tally::bumps(1);
        let raw = raw || self.no_bump_scale;
        let through = |warps: &Warps, bend: &dyn Fn(&Sample, DVec3) -> DVec3| {
            let inner = sample.moved(warps.point(sample.point));
            warps.normal_outward(bend(&inner, warps.normal_inward(n, raw)), raw)
        };
        match &self.kind {
            NormalKind::Pattern(pattern) => {
                through(&pattern.warps, &|sample, n| self.by_pattern(pattern, sample, n))
            }
            NormalKind::Slopes(pattern, slopes) => through(&pattern.warps, &|sample, n| {
                self.by_slopes(sample, n, |p| height(slopes, pattern.value_at(p, sample)))
            }),
            NormalKind::Normals(pattern, map) => {
                let blended = through(&pattern.warps, &|sample, n| match map
                    .pick(pattern.value_at(sample.point, sample))
                {
                    Pick::One(normal) => normal.bend(sample, n, raw),
                    Pick::Two { previous, current, t } => {
                        (1.0 - t) * previous.bend(sample, n, raw) + t * current.bend(sample, n, raw)
                    }
                });
                blended.normalize_or_zero()
            }
            NormalKind::Average(warps, map) => through(warps, &|sample, n| {
                let total: f32 = map.entries().iter().map(|(weight, _)| weight).sum();
                let normals = map.entries().iter();
                let sum: DVec3 = normals
                    .filter(|(weight, _)| *weight != 0.0)
                    .map(|(weight, normal)| f64::from(*weight) * normal.bend(sample, n, raw))
                    .sum();
                sum / f64::from(total)
            }),
            NormalKind::Bumps(warps, map) => {
                through(warps, &|sample, n| map.bend(sample.point, n, self.amount))
            }
            NormalKind::UvMapped(normal) => normal.bend(&sample.uv_mapped(), n, raw).normalize_or_zero(),
        }
    }

    fn by_pattern(&self, pattern: &Pattern, sample: &Sample, n: DVec3) -> DVec3 {
        let (p, amount) = (sample.point, self.amount);
        match &pattern.formula {
            Formula::Facets(facets) => facets.normal(p, n),
            Formula::Ripples(ripples) => ripples.ripple_normal(p, n, amount),
            Formula::Waves(ripples) => ripples.wave_normal(p, n, amount),
            Formula::Quilted(quilted) => n + amount * quilted.bulge(p),
            Formula::Bumps(_) => n + amount * vector_noise(p),
            Formula::Dents(generator) => n + (dents(*generator, p) * amount) * vector_noise(p),
            Formula::Wrinkles(_) => {
                let mut sum = DVec3::ZERO;
                let vectors = vector_noise_scaled(p, &WRINKLES);
                for (octave, scale) in WRINKLES.iter().enumerate() {
                    sum += (vectors[octave] / *scale).abs();
                }
                n + amount * sum
            }
            _ => self.by_slopes(sample, n, |p| pattern.value_at(p, sample)),
        }
    }

    /// Heights at four probes tilt the normal (docs/spec/patterns-textures.md 4.4).
    fn by_slopes(&self, sample: &Sample, n: DVec3, height: impl Fn(DVec3) -> f64) -> DVec3 {
        let strength = (self.amount * -5.0) * (0.02 / self.accuracy);
        PROBES
            .iter()
            .fold(n, |n, probe| n + height(sample.point + self.accuracy * *probe) * strength * *probe)
    }
}

/// A slope map's height at a value (docs/spec/patterns-textures.md 3.3).
fn height(slopes: &BlendMap<DVec2>, value: f64) -> f64 {
    match slopes.pick(value) {
        Pick::One(entry) => entry.x,
        Pick::Two { previous, current, t } => {
            let (DVec2 { x: h0, y: s0 }, DVec2 { x: h1, y: s1 }) = (*previous, *current);
            t * t * t * (s0 + s1 + 2.0 * (h0 - h1)) - t * t * (2.0 * s0 + s1 + 3.0 * (h0 - h1)) + t * s0 + h0
        }
    }
}
