//! How fast noise and splines rise.

use super::{Slant, ZERO};
use crate::math::noise::along::rises;
use crate::math::wide::widest;
use crate::math::{Band, Lanes, Spline};

/// Many times what the noise's derivatives are rounded by.
const ROUNDING: f64 = 1e-9;

impl Slant {
    /// Noise at a point.
    ///
    /// Its derivatives are continuous, and within a radius they are no farther from those in the middle than that
    /// times how fast they change at most. What noise loses where it cuts coordinates off is in its values alone.
    pub fn noise(generator: u8, point: [Self; 3]) -> Self {
        widest(
            #[inline(always)]
            || {
                let value = Band::noise(generator, point.map(|c| c.value));
                // Where it is brought to 0 … 1 by force it doesn't rise.
                let forced = (-value.low()).zip(value.high() - 1.0, f64::max);
                let (steep, bend) = rises(generator, point.map(|c| c.value.middle));
                let [x, y, z] = point.map(|c| c.value.spread());
                let size = point.map(|c| c.value.middle.abs()).into_iter().fold(Lanes::ZERO, |a, b| a + b);
                let radius = (x * x + y * y + z * z).sqrt() + size * (4.0 * f64::EPSILON);
                let beside = radius * bend + ROUNDING;
                let rises_by = |share: [Band; 3]| {
                    let [x, y, z] = [0, 1, 2].map(|axis| {
                        let rise = Band { reach: beside, ..Band::numbers(steep[axis]) };
                        rise.where_positive(-forced, rise.hull(ZERO)) * share[axis]
                    });
                    x + y + z
                };
                let rises = [0, 1].map(|i| rises_by(point.map(|c| c.rises[i])));
                Self { value, rises }
            },
        )
    }

    /// A component of a spline at a key.
    pub fn spline(self, spline: &Spline, component: usize) -> Self {
        let keys = self.value;
        self.with(spline.along(keys, component), spline.rises_along(keys, component))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::noise::noise;
    use crate::math::spline::SplineKind;
    use crate::math::{DVec2, DVec3};

    /// All that two parameters within a square make.
    fn square(middle: DVec2, half: f64) -> [Slant; 2] {
        [0, 1].map(|axis| {
            let line = Band::line(Lanes::splat(middle[axis]), Lanes::ZERO);
            let value = Band { reach: line.reach + half, ..line };
            Slant { value, rises: [0, 1].map(|i| Band::constant(f64::from(u8::from(i == axis)))) }
        })
    }

    /// Checks how fast a function rises between places of squares large and small, but for what its values are off by.
    fn holds(slant: impl Fn([Slant; 2]) -> Slant, value: impl Fn(DVec2) -> f64, off: f64) {
        let mut narrow = 0;
        for n in 0..600_u32 {
            let at = |by: f64| (f64::from(n) * by).fract() * 8.0 - 4.0;
            let (middle, half) =
                (DVec2::new(at(0.754_877_666), at(0.569_840_290_9)), 0.6_f64.powi(n as i32 % 24));
            let found = slant(square(middle, half));
            for axis in [0, 1] {
                let (low, high) = (found.rises[axis].low().0[0], found.rises[axis].high().0[0]);
                narrow += u32::from(high - low < 0.1);
                for step in 0..16_u32 {
                    let place = |turn: u32| {
                        let share = |by: u32| f64::from(by % 16) / 7.5 - 1.0;
                        let mut p = middle + half * DVec2::new(share(step * 3), share(step * 7));
                        p[axis] = middle[axis] + half * share(step + turn);
                        p
                    };
                    let (p, q) = (place(0), place(1 + step % 5));
                    let rise = (value(p) - value(q)) / (p[axis] - q[axis]);
                    let room = (off + 1e-12) / (p[axis] - q[axis]).abs();
                    let is_held = low - room <= rise && rise <= high + room;
                    assert!(is_held, "{rise} beside {low} … {high} at {p:?} {q:?}");
                }
            }
        }
        assert!(narrow > 100, "{narrow}");
    }

    #[test]
    fn noise_rises_as_fast_as_its_slants_say() {
        for generator in 1..=3 {
            holds(
                |[u, v]| Slant::noise(generator, [u, v * 0.7 + u, u * v]),
                |p| noise(generator, DVec3::new(p.x, p.y * 0.7 + p.x, p.x * p.y)),
                2e-7,
            );
        }
    }

    #[test]
    fn splines_rise_as_fast_as_their_slants_say() {
        let points: Vec<_> = (0..7)
            .map(|n| (f64::from(n * n) * 0.3 - 4.0, [f64::from(n).sin(), 0.0, 0.0, 0.0, 0.0]))
            .collect();
        for kind in [SplineKind::Linear, SplineKind::Quadratic, SplineKind::Cubic, SplineKind::Natural] {
            let spline = Spline::new(kind, &points, 1).unwrap();
            holds(|[u, v]| (u + v).spline(&spline, 0), |p| spline.at(p.x + p.y)[0], 0.0);
        }
    }
}
