//! Compiles interiors.

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::math::Transform;
use crate::scene;
use crate::scene::texture::LegacyFinish;
use crate::world::Interior;
use crate::world::interior::{AIR, Fade};

/// An interior's `caustics` counts this much more than a finish's.
const CAUSTICS: f32 = 45.0;

/// What an object is filled with; every object has an interior, if only air.
///
/// `legacy` is what a plain texture's finish says about the interior, as old scenes do; its
/// caustics and refraction replace those of the interior (docs/spec/shading.md 12 and 21).
///
/// `outer` leads from the space where media were written to the world; those that can't be compiled
/// go to `lacking`.
pub fn interior(
    interior: Option<&scene::Interior>,
    legacy: Option<&LegacyFinish>,
    hollow: bool,
    outer: &Transform,
    textures: &mut TextureCompiler,
    lacking: &mut Vec<Unsupported>,
) -> Interior {
    let default = scene::Interior::default();
    let interior = interior.unwrap_or(&default);
    let media = interior.media.iter().filter_map(|media| {
        textures.media(media, outer).map_err(|unsupported| lacking.push(unsupported)).ok()
    });
    let media = media.collect();
    let old = legacy.copied().unwrap_or_default();
    let ior = interior.ior.or(old.ior).filter(|&ior| ior != 0.0);
    let distance = interior.fade_distance;
    Interior {
        ior: ior.map_or(AIR, f64::from),
        // Dispersion needs an index to disperse.
        dispersion: ior.map_or(1.0, |_| f64::from(interior.dispersion)),
        dispersion_samples: interior.dispersion_samples,
        caustics: old.caustics.unwrap_or(interior.caustics * CAUSTICS),
        fade: (distance.abs() > 1e-10).then_some(Fade {
            distance,
            power: interior.fade_power,
            color: interior.fade_color,
        }),
        refraction: old.refraction.unwrap_or(1.0),
        media,
        hollow,
    }
}
