//! `bokeh`: a lens that lets through more light where a pigment is brighter
//! (docs/spec/camera-image.md 8.3).

use super::focal_blur::radical_inverse;
use crate::math::DVec2;
use crate::math::color::grey;
use crate::math::noise::uniform;
use crate::world::sample::{Colors, Sample};
use crate::world::texture::Pigment;

/// `count` places on the lens, each coordinate from -½ to ½, denser where the pigment is brighter on
/// the unit square. A black one gets its places all the same: each try is more likely to do.
pub(super) fn places(pigment: &Pigment, count: usize) -> Vec<DVec2> {
    let patience = 1.0 / (count * count) as f64;
    let mut tries = 0;
    let mut candidates = (1..).map(|k| DVec2::new(radical_inverse(k, 2), radical_inverse(k, 3)));
    let accepted = candidates.by_ref().filter(|place| {
        tries += 1;
        let brightness = f64::from(grey(Colors::color(pigment, &Sample::at(place.extend(0.0))).rgb));
        uniform(tries) < brightness + (tries - 1) as f64 * patience
    });
    accepted.take(count).map(|place| place - 0.5).collect()
}
