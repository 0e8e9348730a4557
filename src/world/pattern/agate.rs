//! `agate` and `marble`: bands that turbulence bends (docs/spec/patterns-textures.md 2.2).

use crate::math::noise::{Octaves, cycle};
use crate::math::{DVec3, Lanes};

/// The turbulence that a formula adds by itself.
#[derive(Clone, Copy, Debug)]
pub struct OwnTurbulence {
    /// Strength.
    pub amount: DVec3,
    /// The noise.
    pub octaves: Octaves,
    /// Its generator.
    pub generator: u8,
}

impl OwnTurbulence {
    /// Turbulence at `p`, before it is scaled by the amount.
    pub(super) fn scalar(&self, p: DVec3) -> f64 {
        self.octaves.scalar(self.generator, p)
    }
}

/// `agate`.
#[derive(Clone, Copy, Debug)]
pub struct Agate {
    /// `agate_turb`.
    pub strength: f64,
    /// The noise in the bands.
    pub octaves: Octaves,
    /// Its generator.
    pub generator: u8,
}

impl Agate {
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let t = match self.strength {
            0.0 => 0.0,
            strength => strength * self.octaves.scalar(self.generator, p),
        };
        band(t, p.z)
    }

    /// [`Self::value`] at four points.
    #[inline(always)]
    pub(super) fn four(&self, point: &[Lanes; 3]) -> Lanes {
        let t = match self.strength {
            0.0 => Lanes::ZERO,
            strength => self.octaves.scalar_at_four(self.generator, point) * strength,
        };
        t.zip(point[2], band)
    }
}

/// How light a band is at a height, with what turbulence adds there.
fn band(t: f64, z: f64) -> f64 {
    let n = 0.5 * (cycle(1.3 * t + 1.1 * z) + 1.0);
    if n < 0.0 { 0.0 } else { n.min(1.0).powf(0.77) }
}

/// `marble`.
#[derive(Clone, Copy, Debug)]
pub struct Marble {
    /// Bends the bands, which are straight without it.
    pub turbulence: Option<OwnTurbulence>,
}

impl Marble {
    pub(super) fn value(&self, p: DVec3) -> f64 {
        p.x + self.turbulence.map_or(0.0, |t| t.amount.x * t.scalar(p))
    }

    /// [`Self::value`] at four points.
    #[inline(always)]
    pub(super) fn four(&self, point: &[Lanes; 3]) -> Lanes {
        match self.turbulence {
            Some(t) => point[0] + t.octaves.scalar_at_four(t.generator, point) * t.amount.x,
            None => point[0],
        }
    }
}
