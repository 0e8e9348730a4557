//! The orbits of all points of short stretches of a line: bounds of how far they escape, of squares and cubes.

use super::{Map, Orbit};
use crate::math::{Band, Lanes};

/// A complex number.
type Complex = [Band; 2];

const ONE: Band = Band::constant(1.0);

/// What is known of an orbit is of no use when it is spread this wide.
const WIDE: f64 = 1e3;

impl Orbit {
    /// What holds [`Orbit::excess`] at all points that these hold.
    #[inline(always)]
    pub(super) fn along(&self, [x, y, z]: &[Band; 3]) -> Band {
        let w = *x * self.slice.x + *y * self.slice.y + *z * self.slice.z + self.slice.w;
        match self.map {
            Map::Square | Map::Cube => self.quaternions([*x, *y, *z, w]),
            _ => self.pairs([[*x - w, *y + *z], [*x + w, *y - *z]]),
        }
    }

    #[inline(always)]
    fn quaternions(&self, mut q: [Band; 4]) -> Band {
        let c = self.constant.to_array();
        let mut most = Most::new(self.escape());
        for turn in 0..self.iterations {
            let squares = q.map(Band::square);
            let imaginary = squares[1] + squares[2] + squares[3];
            if most.meets(squares[0] + imaginary) || turn + 1 == self.iterations {
                break;
            }
            // The imaginary part of the power is a multiple of that of the number.
            let (real, share) = match self.map {
                Map::Square => (squares[0] - imaginary, q[0] * 2.0),
                _ => (q[0] * (squares[0] - imaginary * 3.0), squares[0] * 3.0 - imaginary),
            };
            q = [real + c[0], q[1] * share + c[1], q[2] * share + c[2], q[3] * share + c[3]];
        }
        most.excess
    }

    /// Both complex numbers that a hypercomplex one is made of.
    #[inline(always)]
    fn pairs(&self, mut pair: [Complex; 2]) -> Band {
        let [x, y, z, w] = self.constant.to_array();
        let constants = [[x - w, y + z], [x + w, y - z]];
        let mut most = Most::new(self.escape());
        for turn in 0..self.iterations {
            let [a, b] = pair.map(|[x, y]| x.square() + y.square());
            if most.meets((a + b) * 0.5) || turn + 1 == self.iterations {
                break;
            }
            for (number, c) in pair.iter_mut().zip(constants) {
                let [x, y] = square(*number);
                *number = [x + c[0], y + c[1]];
            }
        }
        most.excess
    }
}

/// The greatest excess of an orbit so far.
struct Most {
    escape: f64,
    excess: Band,
}

impl Most {
    fn new(escape: f64) -> Self {
        Self { escape, excess: Band::constant(-escape) }
    }

    /// Where numbers are spread wide or have become none at all: anything from the excess so far up to 1.
    #[cold]
    fn any(&self) -> Band {
        let (low, one) = (self.excess.low(), Lanes::splat(1.0));
        let least = low.zip(Lanes::splat(-self.escape), f64::max).zip(one, f64::min);
        Band::within(least, one)
    }

    /// Takes the square of a distance; whether all have escaped for good.
    #[inline(always)]
    fn meets(&mut self, square: Band) -> bool {
        let excess = square - self.escape;
        let most = self.excess.max(excess).min(ONE);
        let narrow = -excess.spread() + WIDE;
        let useful = if narrow.all_positive() { most } else { most.where_positive(narrow, self.any()) };
        // What has escaped for good stays so.
        let gone = self.excess.low() - 1.0 + f64::EPSILON * 16.0;
        self.excess = ONE.where_positive(gone, useful);
        (self.excess.low() - 1.0 + f64::EPSILON * 16.0).all_positive()
    }
}

fn square([x, y]: Complex) -> Complex {
    [x.square() - y.square(), x * y * 2.0]
}
