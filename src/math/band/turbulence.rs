//! Octaves of noise, and splines, along lines.

use std::f64::consts::TAU;

use super::{Band, Strip};
use crate::math::noise::along::LATTICE;
use crate::math::noise::{Octaves, vector_noise};
use crate::math::wide::widest;
use crate::math::{DVec3, Lanes, Spline};

/// How steep a component of vector noise is along any line, at most (`math::noise::along`).
const STEEPEST: f64 = LATTICE.first;

/// How fast that changes, at most.
const BEND: f64 = LATTICE.second;

/// More than the largest component: on the average of the corners' weights distances are at most 1/2.
const MOST: f64 = 2.0;

/// The square of half the length of stretches over which [`Band::noise_of`] says nothing.
const VAGUE: f64 = 0.17;

/// What the noise loses where it cuts coordinates off, and to their rounding, as a share.
const SLOP: [f64; 2] = [1e-9, 64.0 * f64::EPSILON];

impl Band {
    /// Noise at points, 0 … 1.
    #[inline(always)]
    pub fn noise(generator: u8, point: [Self; 3]) -> Self {
        let [x, y, z] = &point;
        if (Lanes::dot(&[x.slope, y.slope, z.slope], &[x.slope, y.slope, z.slope]) - VAGUE).all_positive() {
            return Self { reach: Lanes::splat(0.5), ..Self::constant(0.5) };
        }
        widest(
            #[inline(always)]
            || Self::noise_of(generator, point).max(Self::constant(0.0)).min(Self::constant(1.0)),
        )
    }

    /// A sine of period 1.
    pub fn cycle(self) -> Self {
        (self * TAU).sin_cos().0
    }

    /// Vector noise at points, by its values in the middle and at both ends.
    fn vector_noise([x, y, z]: [Self; 3]) -> [Self; 3] {
        let mut parts = [[Strip::UNKNOWN; Lanes::COUNT]; 3];
        for lane in 0..Lanes::COUNT {
            let [x, y, z] = [x, y, z].map(|band| band.lane(lane));
            let (middle, along) =
                (DVec3::new(x.middle, y.middle, z.middle), DVec3::new(x.slope, y.slope, z.slope));
            let slop = SLOP[0] + SLOP[1] * (middle.abs() + along.abs()).element_sum();
            let beside = STEEPEST * (x.reach + y.reach + z.reach) + slop;
            // The slope of the chord is off by half of this at most, and the curve from its tangent.
            let bend = BEND * along.length_squared();
            if bend + beside > MOST || (bend + beside).is_nan() {
                parts.iter_mut().for_each(|part| {
                    part[lane] = Strip { middle: 0.0, slope: 0.0, reach: MOST };
                });
                continue;
            }
            let [from, at, to] = [middle - along, middle, middle + along].map(vector_noise);
            for (axis, part) in parts.iter_mut().enumerate() {
                let slope = 0.5 * (to[axis] - from[axis]);
                part[lane] = Strip { middle: at[axis], slope, reach: bend + beside };
            }
        }
        parts.map(Self::of)
    }
}

impl Octaves {
    /// [`Octaves::scalar`] along lines.
    pub fn scalar_along(&self, generator: u8, p: [Band; 3]) -> Band {
        let (mut frequency, mut strength) = (1.0, 1.0);
        let mut sum = Band::constant(0.0);
        for octave in 0..self.count() {
            let mut n = Band::noise(generator, p.map(|c| c * frequency));
            if generator > 1 {
                n = n * 2.0 - 0.5;
                if octave == 0 {
                    n = n.max(Band::constant(0.0)).min(Band::constant(1.0));
                }
            }
            sum = sum + n * strength;
            frequency *= self.lambda;
            strength *= self.omega;
        }
        sum
    }

    /// [`Octaves::vector`] along lines.
    pub fn vector_along(&self, p: [Band; 3]) -> [Band; 3] {
        let (mut frequency, mut strength) = (1.0, 1.0);
        let mut sums = [Band::constant(0.0); 3];
        for _ in 0..self.count() {
            let vector = Band::vector_noise(p.map(|c| c * frequency));
            for (sum, v) in sums.iter_mut().zip(vector) {
                *sum = *sum + v * strength;
            }
            frequency *= self.lambda;
            strength *= self.omega;
        }
        sums
    }
}

impl Spline {
    /// A component along lines of keys.
    pub fn along(&self, keys: Band, component: usize) -> Band {
        self.by_pieces(keys, |number, keys| {
            let (start, [a, b, c, d]) = self.piece(number, component);
            let k = keys - start;
            let value = ((k * d + c) * k + b) * k + a;
            // The formula that points are worked out with rounds in another order.
            let rounding =
                ROUNDING * (a.abs() + value.middle.0.into_iter().fold(0.0, |m: f64, v| m.max(v.abs())));
            Band { reach: value.reach + rounding, ..value }
        })
    }

    /// How fast a component rises along lines of keys: where pieces meet, as either does.
    pub fn rises_along(&self, keys: Band, component: usize) -> Band {
        self.by_pieces(keys, |number, keys| {
            let (start, [_, b, c, d]) = self.piece(number, component);
            let k = keys - start;
            (k * (3.0 * d) + 2.0 * c) * k + b
        })
    }

    /// What holds all that the pieces of the keys give.
    fn by_pieces(&self, keys: Band, of_piece: impl Fn(usize, Band) -> Band) -> Band {
        let over = |lane: usize| {
            let (low, high) = keys.lane(lane).range();
            if low.is_nan() {
                return Strip::UNKNOWN;
            }
            let [first, last] = [low, high].map(|key| self.place(key));
            if first == last {
                return of_piece(first, keys).lane(lane);
            }
            let all = (first..=last).map(|number| {
                let [from, to] = self.keys_of(number);
                of_piece(number, Band::between(low.max(from), high.min(to))).lane(lane)
            });
            all.reduce(Strip::hull).unwrap_or(Strip::UNKNOWN)
        };
        Band::of([over(0), over(1), over(2), over(3)])
    }
}

/// Many times what a value of a spline is rounded by, as a share.
const ROUNDING: f64 = 1e-13;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::spline::SplineKind;

    /// Checks a band along a line against values.
    #[track_caller]
    fn holds(band: Band, value: impl Fn(f64) -> f64) {
        for step in -16..=16 {
            let s = f64::from(step) / 16.0;
            let line = band.middle.0[1] + band.slope.0[1] * s;
            let off = (value(s) - line).abs();
            assert!(off <= band.reach.0[1], "{off} is beyond {band:?}");
        }
    }

    #[test]
    fn octaves_of_noise_are_held() {
        let octaves = Octaves { count: 4, omega: 0.6, lambda: 2.3 };
        let mut width: f64 = 0.0;
        for n in 0..400 {
            let middle = DVec3::new(0.37, -0.71, 0.53) * f64::from(n) - 40.0;
            let along = DVec3::new(0.3, 0.5, -0.8) * 0.5_f64.powi(n % 24);
            let p = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(along[i])));
            let vector = octaves.vector_along(p);
            for (axis, band) in vector.into_iter().enumerate() {
                holds(band, |s| octaves.vector(middle + s * along)[axis]);
            }
            for generator in 1..=3 {
                let band = octaves.scalar_along(generator, p);
                holds(band, |s| octaves.scalar(generator, middle + s * along));
                if n % 24 == 20 {
                    width = width.max(band.spread().0[0]);
                }
            }
        }
        assert!(width < 1e-4, "{width}");
    }

    #[test]
    fn splines_are_held() {
        let points: Vec<_> = (0..7)
            .map(|n| (f64::from(n * n) * 0.3, [f64::from(n).sin(), f64::from(n * n % 5), 0.0, 0.0, 0.0]))
            .collect();
        for kind in [SplineKind::Linear, SplineKind::Quadratic, SplineKind::Cubic, SplineKind::Natural] {
            let spline = Spline::new(kind, &points, 2).unwrap();
            for n in 0..600 {
                let (middle, half) = (f64::from(n) * 0.025 - 2.0, 2.0 * 0.5_f64.powi(n % 30));
                let keys = Band::line(Lanes::splat(middle), Lanes::splat(half));
                for component in 0..2 {
                    holds(spline.along(keys, component), |s| spline.at(middle + half * s)[component]);
                }
            }
        }
    }
}
