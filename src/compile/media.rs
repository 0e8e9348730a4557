//! Compiles media.

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::math::confidence::thresholds;
use crate::math::{Rgb, Transform};
use crate::scene;
use crate::scene::interior::Scattering;
use crate::scene::pigment::PigmentKind;
use crate::world::Media;
use crate::world::media::{Density, Extra, Method, Phase, Sampling};
use crate::world::warp::{Warp, Warps};

impl TextureCompiler<'_> {
    /// Media in a space that `outer` leads out of.
    ///
    /// # Errors
    /// What its densities use that povista lacks, or a file that can't be read.
    pub fn media(&mut self, media: &scene::Media, outer: &Transform) -> Result<Media, Unsupported> {
        let scattering = media.scattering.as_ref();
        let color = scattering.map_or(Rgb::ZERO, |scattering| scattering.color);
        let loss = scattering.map_or(Rgb::ZERO, |scattering| scattering.color * scattering.extinction);
        Ok(Media {
            sampling: sampling(media),
            extinction: media.absorption + loss,
            emission: media.emission,
            scattering: color,
            phase: scattering.map_or(Phase::Isotropic, phase),
            density: self.density(&media.densities, outer)?,
        })
    }

    fn density(
        &mut self,
        densities: &[std::sync::Arc<scene::Density>],
        outer: &Transform,
    ) -> Result<Density, Unsupported> {
        let mut uniform = Rgb::ONE;
        let mut varying = Vec::new();
        for density in densities {
            match &density.kind {
                PigmentKind::Color(color) => uniform *= color.rgb,
                _ => varying.push(self.pigment(density)?),
            }
        }
        let step = (!outer.is_identity()).then(|| Warp::Transform(Box::new(*outer)));
        Ok(Density::new(Warps::new(step), uniform, varying))
    }
}

fn sampling(media: &scene::Media) -> Sampling {
    let [min_samples, max_samples] = media.samples;
    let extra = || {
        let more = max_samples > min_samples;
        let (confidence, variance) = (f64::from(media.confidence), f64::from(media.variance));
        let thresholds = if more { thresholds(max_samples, confidence, variance) } else { Vec::new() };
        Extra { thresholds: thresholds.into() }
    };
    Sampling {
        method: match media.method {
            1 => Method::Random(extra()),
            2 => Method::Even(extra()),
            _ => Method::Adaptive { threshold: media.aa_threshold, level: media.aa_level },
        },
        intervals: media.intervals,
        min_samples,
        jitter: f64::from(media.jitter),
        ratio: f64::from(media.ratio),
        plain: media.densities.is_empty(),
    }
}

fn phase(scattering: &Scattering) -> Phase {
    match scattering.kind {
        2 => Phase::MieHazy,
        3 => Phase::MieMurky,
        4 => Phase::Rayleigh,
        5 => Phase::HenyeyGreenstein(f64::from(scattering.eccentricity)),
        _ => Phase::Isotropic,
    }
}
