//! Patterns at four points at once: those made of noise, where that pays most, and some more; the others one after the
//! other.

use super::{Formula, PERIOD, Pattern, Wave, falloff, fold, noise};
use crate::math::noise::noise_at_four;
use crate::math::wide::widest;
use crate::math::{Lanes, tally};
use crate::world::sample::{Samples, one_by_one};

impl Pattern {
    /// The finished values at four samples.
    pub(super) fn values(&self, samples: &Samples) -> Lanes {
        let steps = &self.warps;
        let (raw, point) = widest(
            #[inline(always)]
            || {
                let point = steps.four_steps(samples.point);
                (self.formula.in_lanes(&point), point)
            },
        );
        self.told(raw, &samples.moved(point))
    }

    /// [`Pattern::value_at`] of four points, which have gone through `warps` already.
    pub fn values_at(&self, point: &[Lanes; 3], samples: &Samples) -> Lanes {
        let raw = widest(
            #[inline(always)]
            || self.formula.in_lanes(point),
        );
        self.told(raw, &samples.moved(*point))
    }

    /// What the formula gives where it isn't found [in lanes](Formula::in_lanes), with frequency, phase and wave.
    #[inline]
    fn told(&self, in_lanes: Option<Lanes>, samples: &Samples) -> Lanes {
        tally::patterns(Lanes::COUNT);
        self.finish_four(in_lanes.unwrap_or_else(|| self.formula.four(samples)))
    }

    /// Frequency, phase and wave of four values.
    #[inline]
    fn finish_four(&self, raw: Lanes) -> Lanes {
        let v = if self.frequency == 0.0 { raw } else { raw * self.frequency + self.phase };
        let within_period = v.bits(|v| (0.0..PERIOD).contains(&v)) == 0b1111;
        if within_period && self.wave == Wave::Ramp { v } else { one_by_one(|lane| self.finish(raw.0[lane])) }
    }
}

impl Formula {
    /// [`Formula::raw`] at four points of those that aren't found [in lanes](Self::in_lanes).
    fn four(&self, samples: &Samples) -> Lanes {
        match self {
            Self::Function(function) => function.four(samples).map(fold),
            Self::Pigment(pigment) => pigment.four(samples),
            Self::Crackle(crackle) => crackle.four(&samples.point),
            Self::Wrinkles(generator) => noise::wrinkles_at_four(*generator, &samples.point),
            _ => one_by_one(|lane| self.raw(samples.point_of(lane), samples.surface(lane))),
        }
    }

    /// What is made of noise or of a few operations; `None` of others.
    #[inline(always)]
    fn in_lanes(&self, point: &[Lanes; 3]) -> Option<Lanes> {
        let [x, y, z] = *point;
        Some(match self {
            Self::Agate(agate) => agate.four(point),
            Self::Boxed => falloff::boxed_at_four(point),
            Self::Bozo(generator) | Self::Bumps(generator) => noise_at_four(*generator, x, y, z),
            Self::Cylindrical => falloff::cylindrical_at_four(point),
            Self::Gradient(direction) => (x * direction.x + y * direction.y + z * direction.z).map(fold),
            Self::Dents(generator) => noise::dents_at_four(*generator, point),
            Self::Granite(generator) => noise::granite_at_four(*generator, point),
            Self::Marble(marble) => marble.four(point),
            Self::Planar => y.abs().map(falloff::fall),
            Self::Spherical => falloff::spherical_at_four(point),
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;
    use crate::math::noise::Octaves;
    use crate::world::pattern::agate::{Agate, Marble, OwnTurbulence};
    use crate::world::sample::Field;
    use crate::world::warp::{Repeat, Warp, Warps};

    #[test]
    fn four_at_once_are_as_one_after_the_other() {
        let octaves = Octaves { count: 5, omega: 0.6, lambda: 1.9 };
        let turbulence = OwnTurbulence { amount: DVec3::splat(0.7), octaves, generator: 2 };
        let formulas = [
            Formula::Agate(Agate { strength: 0.8, octaves, generator: 1 }),
            Formula::Boxed,
            Formula::Bozo(2),
            Formula::Checker,
            Formula::Cylindrical,
            Formula::Dents(1),
            Formula::Gradient(DVec3::new(0.6, 0.0, -0.8)),
            Formula::Granite(1),
            Formula::Granite(2),
            Formula::Marble(Marble { turbulence: None }),
            Formula::Marble(Marble { turbulence: Some(turbulence) }),
            Formula::Planar,
            Formula::Spherical,
            Formula::Wrinkles(1),
            Formula::Wrinkles(3),
        ];
        let repeat = Repeat::new(DVec3::X * 0.7, DVec3::ZERO, DVec3::ZERO);
        for (number, formula) in formulas.into_iter().enumerate() {
            let bent = Warps::new([
                Warp::Repeat(Box::new(repeat.clone())),
                Warp::Turbulence(DVec3::new(0.3, 0.4, 0.5), octaves),
            ]);
            let frequency = number as f64 % 3.0 * 1.3;
            let pattern = Pattern { warps: bent, frequency, phase: -0.2, ..Pattern::plain(formula) };
            for n in 0..200 {
                let step = 0.003 * 1.04_f64.powi(n);
                let along = Lanes([0.0, 1.0, 2.0, 3.0]) * step;
                let point =
                    [along + f64::from(n) * 0.37 - 30.0, along * 0.2 - 1.3, Lanes::splat(f64::from(n % 3))];
                let samples = Samples::at(&point);
                let expected = [0, 1, 2, 3].map(|lane| pattern.value(&samples.get(lane)));
                let found = pattern.four(&samples).0;
                assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "{:?}", pattern.formula);
            }
        }
    }
}
