//! Patterns along lines: bounds of their values, for surfaces that are made of them.
//!
//! Of patterns that jump, and of those made of cells, nothing is said.

use std::f64::consts::{PI, TAU};

use super::noise::WRINKLES;
use super::{Formula, PERIOD, Pattern, Wave, agate, ripples, wood};
use crate::math::{Band, DVec3};
use crate::world::warp::{Warp, Warps};

/// A point.
type Point = [Band; 3];

const ZERO: Band = Band::constant(0.0);
const ONE: Band = Band::constant(1.0);

impl Pattern {
    /// Whether [`Pattern::along`] says something.
    pub(super) fn is_held(&self) -> bool {
        self.warps.are_held() && self.formula.is_held()
    }

    /// What holds the finished values at all points that these hold.
    pub(super) fn along(&self, point: &Point) -> Band {
        let mut v = self.formula.along(&self.warps.along(*point));
        let mut positive = self.formula.is_positive();
        if self.frequency != 0.0 {
            v = (v * self.frequency + self.phase).remainder(Band::constant(PERIOD));
            positive &= self.frequency > 0.0 && self.phase >= 0.0;
        }
        if !positive {
            let all = v.max(ZERO).hull(Band::between(0.0, 1.0));
            v = v.where_positive(v.low(), (v - v.floor()).where_positive(-v.high(), all));
        }
        match self.wave {
            Wave::Ramp => v,
            Wave::Triangle => -(v.remainder(ONE) * 2.0 - 1.0).abs() + 1.0,
            Wave::Sine => (v.cycle() + 1.0) * 0.5,
            Wave::Scallop => (v * 0.5).cycle().abs(),
            Wave::Cubic => v * v * (v * -2.0 + 3.0),
            Wave::Poly(exponent) => v.powf(Band::constant(exponent)),
        }
    }
}

impl Formula {
    fn is_held(&self) -> bool {
        match self {
            Self::Function(field) | Self::Pigment(field) => field.is_known(),
            Self::Agate(_)
            | Self::Boxed
            | Self::Bozo(_)
            | Self::Bumps(_)
            | Self::Cylindrical
            | Self::Dents(_)
            | Self::Gradient(_)
            | Self::Granite(_)
            | Self::Leopard
            | Self::Marble(_)
            | Self::Onion
            | Self::Planar
            | Self::Radial
            | Self::Ripples(_)
            | Self::Spherical
            | Self::Waves(_)
            | Self::Wood(_)
            | Self::Wrinkles(_) => true,
            _ => false,
        }
    }

    /// Whether raw values are never negative.
    fn is_positive(&self) -> bool {
        !matches!(
            self,
            Self::Function(_) | Self::Pigment(_) | Self::Gradient(_) | Self::Marble(_) | Self::Waves(_)
        )
    }

    fn along(&self, p: &Point) -> Band {
        let [x, y, z] = *p;
        match self {
            Self::Agate(agate) => agate.along(p),
            Self::Boxed => fall(x.abs().max(y.abs()).max(z.abs())),
            Self::Bozo(generator) | Self::Bumps(generator) => Band::noise(*generator, *p),
            Self::Cylindrical => fall((x.square() + z.square()).sqrt()),
            Self::Dents(generator) => {
                let n = Band::noise(*generator, *p);
                n * n * n
            }
            Self::Function(function) => fold(function.enclose(p)),
            Self::Gradient(d) => fold(x * d.x + y * d.y + z * d.z),
            Self::Granite(generator) => granite(*generator, p),
            Self::Leopard => {
                let wave = (x.sin_cos().0 + y.sin_cos().0 + z.sin_cos().0) * (1.0 / 3.0);
                wave.square()
            }
            Self::Marble(marble) => marble.along(p),
            Self::Onion => length(p).remainder(ONE),
            Self::Pigment(pigment) => pigment.enclose(p),
            Self::Planar => fall(y.abs()),
            Self::Radial => radial(p),
            Self::Ripples(ripples) => ripples.ripples_along(p),
            Self::Spherical => fall(length(p)),
            Self::Waves(ripples) => ripples.waves_along(p),
            Self::Wood(wood) => wood.along(p),
            Self::Wrinkles(generator) => wrinkles(*generator, p),
            _ => Band::UNKNOWN,
        }
    }
}

fn length([x, y, z]: &Point) -> Band {
    (x.square() + y.square() + z.square()).sqrt()
}

fn fall(distance: Band) -> Band {
    -distance.max(ZERO).min(ONE) + 1.0
}

/// Values over 1 start again at 0; negative ones stay.
fn fold(v: Band) -> Band {
    let over = v.low() - 1.0;
    if (-v.high() + 1.0).all_positive() {
        return v;
    }
    let both = v.min(ONE).hull(Band::between(0.0, 1.0));
    v.where_positive(-v.high() + 1.0, v.remainder(ONE).where_positive(over, both))
}

fn granite(generator: u8, p: &Point) -> Band {
    let mut sum = ZERO;
    for octave in 0..6 {
        let scale = f64::from(1 << octave);
        let n = Band::noise(generator, p.map(|c| c * (4.0 * scale)));
        let folded =
            if generator <= 1 { (n - 0.5).abs() } else { (n * 2.0 - 1.0).abs().min(Band::constant(0.5)) };
        sum = sum + folded * (1.0 / scale);
    }
    sum
}

fn wrinkles(generator: u8, p: &Point) -> Band {
    let mut sum = ZERO;
    for scale in WRINKLES {
        let n = Band::noise(generator, p.map(|c| c * scale));
        let height = if generator <= 1 { n } else { (n * 2.0 - 0.5).max(ZERO).min(ONE) };
        sum = sum + height * (1.0 / scale);
    }
    sum * 0.5
}

/// Near the axis the pattern has a value of its own.
fn radial([x, _, z]: &Point) -> Band {
    let angle = (x.atan2(*z) + PI) * (1.0 / TAU) + 0.25;
    let off_axis = (x.abs().max(z.abs()) - 0.001).low();
    angle.where_positive(off_axis, Band::between(0.25, 1.25))
}

impl agate::Agate {
    fn along(&self, p: &Point) -> Band {
        let t = match self.strength {
            0.0 => ZERO,
            strength => self.octaves.scalar_along(self.generator, *p) * strength,
        };
        let n = ((t * 1.3 + p[2] * 1.1).cycle() + 1.0) * 0.5;
        n.max(ZERO).min(ONE).powf(Band::constant(0.77))
    }
}

impl agate::Marble {
    fn along(&self, p: &Point) -> Band {
        match self.turbulence {
            Some(t) => p[0] + t.octaves.scalar_along(t.generator, *p) * t.amount.x,
            None => p[0],
        }
    }
}

impl wood::Wood {
    fn along(&self, p: &Point) -> Band {
        let [mut x, mut y, _] = *p;
        if let Some(t) = self.turbulence {
            let [dx, dy, _] = t.octaves.vector_along(*p);
            (x, y) = (((x + dx) * t.amount.x).cycle() + x, ((y + dy) * t.amount.y).cycle() + y);
        }
        (x.square() + y.square()).sqrt()
    }
}

impl ripples::Ripples {
    fn sum(&self, p: &Point, height: impl Fn(Band, f64) -> Band) -> Band {
        let mut sum = ZERO;
        for source in self.sources.iter() {
            let away = length(&[p[0] - source.center.x, p[1] - source.center.y, p[2] - source.center.z]);
            // At the source itself the distance counts as 1.
            let away = away.where_positive(away.low(), away.hull(ONE));
            sum = sum + height(away, source.frequency);
        }
        sum * (1.0 / self.sources.len() as f64)
    }

    fn ripples_along(&self, p: &Point) -> Band {
        (self.sum(p, |away, _| (away * self.frequency + self.phase).cycle()) + 1.0) * 0.5
    }

    fn waves_along(&self, p: &Point) -> Band {
        let height = |away: Band, f: f64| (away * (self.frequency * f) + self.phase).cycle() * (1.0 / f);
        (self.sum(p, height) + 2.5) * 0.2
    }
}

impl Warps {
    /// Whether [`Warps::along`] says something.
    fn are_held(&self) -> bool {
        self.steps().iter().all(|step| matches!(step, Warp::Transform(_) | Warp::Turbulence(..)))
    }

    fn along(&self, mut p: Point) -> Point {
        for step in self.steps() {
            p = match step {
                Warp::Transform(transform) => {
                    let [axes @ .., origin] =
                        [DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO].map(|p| transform.inverse_point(p));
                    let [x, y, z] = p;
                    [0, 1, 2].map(|i| {
                        let [a, b, c] = axes.map(|axis| axis[i] - origin[i]);
                        x * a + y * b + z * c + origin[i]
                    })
                }
                Warp::Turbulence(amount, octaves) => {
                    let [x, y, z] = octaves.vector_along(p);
                    [p[0] + x * amount.x, p[1] + y * amount.y, p[2] + z * amount.z]
                }
                _ => [Band::UNKNOWN; 3],
            };
        }
        p
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::noise::Octaves;
    use crate::math::{Lanes, Transform};
    use crate::world::sample::{Field, Sample};

    /// Checks that bands along lines long and short hold a pattern's values, and that short ones are narrow.
    #[track_caller]
    fn holds(pattern: &Pattern) {
        assert!(pattern.is_known());
        let mut narrow = 0;
        for n in 0..300 {
            let middle = DVec3::new(0.017, -0.023, 0.019) * f64::from(n) + DVec3::new(-2.1, 3.2, -2.7);
            let along = DVec3::new(0.6, 0.5, -0.7) * 0.5_f64.powi(n % 30);
            let at = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(along[i])));
            let band = pattern.enclose(&at);
            for step in -8..=8 {
                let s = f64::from(step) / 8.0;
                let value = pattern.value(&Sample::at(middle + s * along));
                let line = band.middle.0[2] + band.slope.0[2] * s;
                let off = (value - line).abs();
                assert!(
                    off <= band.reach.0[2] * (1.0 + 1e-12),
                    "{pattern:?} at {middle} + {s} {along}: {value}, {band:?}"
                );
            }
            if n % 30 == 29 {
                narrow += u32::from(band.reach.0[2] < 1e-5);
            }
        }
        assert!(narrow >= 6, "{pattern:?}: {narrow}");
    }

    #[test]
    fn bands_of_patterns_hold_their_values() {
        let octaves = Octaves { count: 3, omega: 0.5, lambda: 2.0 };
        let own = agate::OwnTurbulence { amount: DVec3::new(0.4, 0.3, 0.2), octaves, generator: 2 };
        let formulas = [
            Formula::Agate(agate::Agate { strength: 1.0, octaves, generator: 2 }),
            Formula::Boxed,
            Formula::Bozo(1),
            Formula::Bozo(3),
            Formula::Cylindrical,
            Formula::Dents(2),
            Formula::Gradient(DVec3::new(0.6, 0.8, 0.0)),
            Formula::Granite(1),
            Formula::Granite(2),
            Formula::Leopard,
            Formula::Marble(agate::Marble { turbulence: Some(own) }),
            Formula::Onion,
            Formula::Planar,
            Formula::Radial,
            Formula::Spherical,
            Formula::Wood(wood::Wood { turbulence: None }),
            Formula::Wood(wood::Wood { turbulence: Some(own) }),
            Formula::Wrinkles(2),
        ];
        let turned =
            Transform::rotate(DVec3::new(20.0, 30.0, 40.0)).then(&Transform::scale(DVec3::splat(1.7)));
        let steps = [Warp::Transform(Box::new(turned)), Warp::Turbulence(DVec3::new(0.3, 0.2, 0.4), octaves)];
        let waves = [Wave::Ramp, Wave::Triangle, Wave::Sine, Wave::Scallop, Wave::Cubic, Wave::Poly(1.5)];
        for (n, formula) in formulas.into_iter().enumerate() {
            holds(&Pattern::plain(formula.clone()));
            let warps = Warps::new(steps.clone());
            holds(&Pattern {
                warps,
                frequency: 1.7,
                phase: 0.2,
                wave: waves[n % 6],
                ..Pattern::plain(formula)
            });
        }
    }
}
