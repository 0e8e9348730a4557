//! Compiles interiors.

use super::Unsupported;
use crate::scene;
use crate::scene::texture::LegacyFinish;
use crate::world::Interior;
use crate::world::interior::{AIR, Fade};

/// What an object is filled with; every object has an interior, if only air.
///
/// `legacy` is what a plain texture's finish says about the interior, as old scenes do; its
/// caustics and refraction replace those of the interior (docs/spec/shading.md 12 and 21).
///
/// # Errors
/// Media is not supported yet.
pub fn interior(
    interior: Option<&scene::Interior>,
    legacy: Option<&LegacyFinish>,
    hollow: bool,
) -> Result<Interior, Unsupported> {
    let default = scene::Interior::default();
    let interior = interior.unwrap_or(&default);
    if let Some(media) = interior.media.first() {
        return Err(Unsupported::new(media.span, "media"));
    }
    let old = legacy.copied().unwrap_or_default();
    let ior = old.ior.or(interior.ior).filter(|&ior| ior != 0.0);
    let distance = old.fade_distance.unwrap_or(interior.fade_distance);
    Ok(Interior {
        ior: ior.map_or(AIR, f64::from),
        // Dispersion needs an index to disperse.
        dispersion: ior.map_or(1.0, |_| f64::from(interior.dispersion)),
        dispersion_samples: interior.dispersion_samples,
        caustics: old.caustics.unwrap_or(interior.caustics),
        fade: (distance.abs() > 1e-10).then(|| Fade {
            distance,
            power: old.fade_power.unwrap_or(interior.fade_power),
            color: interior.fade_color,
        }),
        refraction: match legacy {
            Some(finish) => finish.refraction.unwrap_or(1.0),
            None => interior.refraction.unwrap_or(1.0),
        },
        hollow,
    })
}
