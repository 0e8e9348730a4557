//! Where scattered light goes (docs/spec/atmosphere-gi.md 2.4).

/// The types of `scattering`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Phase {
    /// 1: everywhere alike.
    #[default]
    Isotropic,
    /// 2: Mie scattering of haze.
    MieHazy,
    /// 3: Mie scattering of murky air.
    MieMurky,
    /// 4: of particles much smaller than a wavelength.
    Rayleigh,
    /// 5: with its `eccentricity`; forward where that is positive.
    HenyeyGreenstein(f64),
}

impl Phase {
    /// The share scattered towards the eye; `cosine` is that between the viewing ray and the way to
    /// the light. Not normalised to the same mean.
    pub fn share(self, cosine: f64) -> f32 {
        let share = match self {
            Self::Isotropic => 1.0,
            Self::MieHazy => 0.576_655_375 * (1.0 + 9.0 * ((1.0 + cosine) / 2.0).powi(8)),
            Self::MieMurky => 0.495_714_547 * (1.0 + 50.0 * ((1.0 + cosine) / 2.0).powi(32)),
            Self::Rayleigh => 0.799_372_013 * (1.0 + cosine * cosine),
            Self::HenyeyGreenstein(g) => {
                let spread = 1.0 + g * g - 2.0 * g * cosine;
                // All light goes on, or back: nothing is left for any other direction.
                if spread > 0.0 { (1.0 - g * g) / (spread * spread.sqrt()) } else { 0.0 }
            }
        };
        share as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Row M19 of docs/spec/atmosphere-gi.md: a slab .01 thick of colour 20 without extinction, lit
    /// across and at 45 degrees.
    #[test]
    fn shares_are_the_observed_ones() {
        let observed = [
            (Phase::MieHazy, 0.1194, 0.4078),
            (Phase::MieMurky, 0.0991, 0.1304),
            (Phase::Rayleigh, 0.1599, 0.2398),
            (Phase::HenyeyGreenstein(0.5), 0.1073, 0.3750),
        ];
        for (phase, across, slanted) in observed {
            for (cosine, seen) in [(0.0, across), (0.5_f64.sqrt(), slanted)] {
                let ours = 0.2 * phase.share(cosine);
                assert!((ours - seen).abs() < 5e-4, "{phase:?} at {cosine}: {ours} not {seen}");
            }
        }
    }

    #[test]
    fn extreme_eccentricities_stay_finite() {
        for g in [-1.0, 1.0, 1.0 - 1e-17, 5.0] {
            for cosine in [-1.0, 0.0, 1.0] {
                assert!(Phase::HenyeyGreenstein(g).share(cosine).is_finite(), "{g} {cosine}");
            }
        }
    }
}
