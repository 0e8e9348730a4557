//! `rainbow`: a coloured arc around a direction (docs/spec/atmosphere-gi.md 1.7).

use std::sync::Arc;

use super::Veil;
use crate::math::{DVec3, Rgb};
use crate::world::Ray;
use crate::world::sample::Sample;
use crate::world::texture::Pigment;

/// An arc; its angles are in radians.
#[derive(Debug)]
pub struct Rainbow {
    /// Unit vector from which the arc's angle is measured.
    pub direction: DVec3,
    /// Unit vectors across and upwards.
    pub right: DVec3,
    /// Unit vector upwards.
    pub up: DVec3,
    /// Inner edge.
    pub start: f64,
    /// From the inner edge to the outer.
    pub width: f64,
    /// How far a ray's place on the bow is moved at random, in widths.
    pub jitter: f64,
    /// Distance at which it has 1 - 1/e of its strength.
    pub distance: f64,
    /// Half the arc, measured around the direction.
    pub arc: f64,
    /// Half the part of the arc that doesn't fade.
    pub falloff: f64,
    /// Colours from the inner edge at x = 0 to the outer at x = 1.
    pub colors: Arc<Pigment>,
}

/// A rainbow's colour and how much of the background it leaves.
struct Bow {
    strength: f32,
    color: crate::math::Rgbft,
}

/// What all rainbows do to light from `distance` along the ray: the mean of those that are there.
///
/// `random` gives numbers uniform in 0 … 1; only bows with jitter ask for one.
pub(super) fn veil(rainbows: &[Rainbow], ray: &Ray, distance: f64, random: &mut dyn FnMut() -> f64) -> Veil {
    let (mut added, mut factor, mut transmit, mut count) = (Rgb::ZERO, Rgb::ZERO, 1.0, 0.0);
    for Bow { strength, color } in rainbows.iter().filter_map(|bow| bow.seen(ray, distance, random)) {
        let filter = color.filter * (1.0 - strength);
        added += color.rgb * (1.0 - strength);
        factor += (Rgb::splat(1.0 - filter) + color.rgb * filter) * strength;
        transmit *= strength * color.transmit;
        count += 1.0;
    }
    if count == 0.0 {
        return Veil::NONE;
    }
    Veil { added: added / count, factor: factor / count, transmit }
}

impl Rainbow {
    fn seen(&self, ray: &Ray, distance: f64, random: &mut dyn FnMut() -> f64) -> Option<Bow> {
        let (x, y) = (ray.direction.dot(self.right), ray.direction.dot(self.up));
        let cosine = ray.direction.dot(self.direction);
        let off_axis = x.hypot(y);
        let around = if off_axis > 0.0 { (y / off_axis).clamp(-1.0, 1.0) } else { 0.0 }.acos().abs();
        if around > self.arc || cosine < 0.0 {
            return None;
        }
        let mut index = (cosine.min(1.0).acos() - self.start) / self.width;
        if self.jitter != 0.0 {
            index += (2.0 * random() - 1.0) * self.jitter;
        }
        if !(0.0..=1.0 - 1e-10).contains(&index) {
            return None;
        }
        let color = self.colors.color(&Sample::at(DVec3::new(index, 0.0, 0.0)))?;
        let fade = if self.arc > self.falloff && around > self.falloff {
            let h = (around - self.falloff) / (self.arc - self.falloff);
            ((3.0 - 2.0 * h) * h * h) as f32
        } else {
            0.0
        };
        let strength = (-distance / self.distance).min(80.0).exp() as f32;
        Some(Bow { strength: strength.max(fade * (1.0 - color.transmit) + color.transmit), color })
    }
}
