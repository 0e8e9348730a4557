//! Cubic pieces of curves, and the zeros of polynomials that they make with a line.

use crate::certify::{Along, Zeros, zeros};
use crate::double::Double;
use crate::interval::{Interval, Scalar};
use crate::model::Line;
use crate::real::{Jet, Moved};

/// The coefficients of a polynomial, the constant first.
pub(crate) type Poly<S> = Vec<Interval<S>>;

pub(crate) fn plus<S: Scalar>(a: &Poly<S>, b: &Poly<S>) -> Poly<S> {
    let at = |p: &Poly<S>, i: usize| p.get(i).copied().unwrap_or(Interval::of(0.0));
    (0..a.len().max(b.len())).map(|i| at(a, i) + at(b, i)).collect()
}

pub(crate) fn times<S: Scalar>(a: &Poly<S>, b: &Poly<S>) -> Poly<S> {
    let mut out = vec![Interval::of(0.0); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            out[i + j] = out[i + j] + *x * *y;
        }
    }
    out
}

pub(crate) fn scaled<S: Scalar>(a: &Poly<S>, by: Interval<S>) -> Poly<S> {
    a.iter().map(|x| *x * by).collect()
}

pub(crate) fn raised<S: Scalar>(mut a: Poly<S>, by: Interval<S>) -> Poly<S> {
    a[0] = a[0] + by;
    a
}

pub(crate) fn derivative<S: Scalar>(a: &Poly<S>) -> Poly<S> {
    (1..).zip(&a[1..]).map(|(i, x)| *x * Interval::of(f64::from(i))).collect()
}

/// The value at a number.
pub(crate) fn value(a: &Poly<Double>, at: Double) -> Double {
    a.iter().rev().fold(Double::of(0.0), |sum, c| sum * at + c.middle())
}

/// A curve in N dimensions over w from 0 to 1: points by powers of w.
#[derive(Clone, Copy)]
pub(crate) struct Piece<const N: usize>([[Double; N]; 4]);

impl<const N: usize> Piece<N> {
    /// From sums of control points, each so many times, over a divisor.
    fn of(points: &[[f64; N]], weights: [&[f64]; 4], divisor: f64) -> Self {
        Self(weights.map(|weights| {
            std::array::from_fn(|i| {
                let terms = points.iter().zip(weights).map(|(p, w)| Double::of(p[i]) * Double::of(*w));
                terms.fold(Double::of(0.0), |sum, term| sum + term) / Double::of(divisor)
            })
        }))
    }

    /// From the first point to the second.
    pub(crate) fn linear(points: &[[f64; N]; 2]) -> Self {
        Self::of(points, [&[1., 0.], &[-1., 1.], &[], &[]], 1.0)
    }

    /// From the second point to the third.
    pub(crate) fn quadratic(points: &[[f64; N]; 3]) -> Self {
        Self::of(points, [&[0., 2., 0.], &[-1., 0., 1.], &[1., -2., 1.], &[]], 2.0)
    }

    /// From the second point to the third (Catmull and Rom).
    pub(crate) fn cubic(points: &[[f64; N]; 4]) -> Self {
        let weights: [&[f64]; 4] =
            [&[0., 2., 0., 0.], &[-1., 0., 1., 0.], &[2., -5., 4., -1.], &[-1., 3., -3., 1.]];
        Self::of(points, weights, 2.0)
    }

    /// A stretch of a uniform B-spline.
    pub(crate) fn b_spline(points: &[[f64; N]; 4]) -> Self {
        let weights: [&[f64]; 4] =
            [&[1., 4., 1., 0.], &[-3., 0., 3., 0.], &[3., -6., 3., 0.], &[-1., 3., -3., 1.]];
        Self::of(points, weights, 6.0)
    }

    /// With two ends and a control point between.
    pub(crate) fn parabola(points: &[[f64; N]; 3]) -> Self {
        Self::of(points, [&[1., 0., 0.], &[-2., 2., 0.], &[1., -2., 1.], &[]], 1.0)
    }

    /// With two ends and two control points between.
    pub(crate) fn bezier(points: &[[f64; N]; 4]) -> Self {
        let weights: [&[f64]; 4] =
            [&[1., 0., 0., 0.], &[-3., 3., 0., 0.], &[3., -6., 3., 0.], &[-1., 3., -3., 1.]];
        Self::of(points, weights, 1.0)
    }

    /// One coordinate as a polynomial.
    pub(crate) fn coordinate<S: Scalar>(&self, i: usize) -> Poly<S> {
        self.0.iter().map(|c| S::around(c[i])).collect()
    }

    pub(crate) fn at(&self, w: Double) -> [Double; N] {
        std::array::from_fn(|i| value(&self.coordinate(i), w))
    }

    pub(crate) fn slope(&self, w: Double) -> [f64; N] {
        std::array::from_fn(|i| value(&derivative(&self.coordinate(i)), w).to_f64())
    }
}

/// A line as polynomials see it.
pub(crate) struct Beam<S> {
    pub(crate) origin: [Interval<S>; 3],
    pub(crate) direction: [Interval<S>; 3],
}

impl Beam<Double> {
    pub(crate) fn fine(line: &Line) -> Self {
        Self { origin: line.origin.map(Interval::point), direction: line.direction.map(Interval::point) }
    }

    pub(crate) fn at(&self, t: Double) -> [Double; 3] {
        std::array::from_fn(|i| self.origin[i].middle() + t * self.direction[i].middle())
    }
}

impl Beam<f64> {
    /// With room for other lines that rounding cannot tell from this one.
    pub(crate) fn rough(line: &Line) -> Self {
        Self {
            origin: line.origin.map(|x| f64::loosely(x, line.room)),
            direction: line.direction.map(f64::around),
        }
    }
}

/// A polynomial that a line makes.
pub(crate) trait Made {
    fn made<S: Scalar>(&self, beam: &Beam<S>) -> Poly<S>;
}

struct Both {
    rough: Poly<f64>,
    fine: Poly<Double>,
}

fn jet<S: Scalar>(a: &Poly<S>, at: Interval<S>) -> Jet<S> {
    let zero = Jet { value: Interval::of(0.0), slope: Interval::of(0.0) };
    a.iter().rev().fold(zero, |sum, c| Jet { value: sum.value * at + *c, slope: sum.slope * at + sum.value })
}

impl Along for Both {
    fn rough(&self, t: Interval<f64>) -> Jet<f64> {
        jet(&self.rough, t)
    }

    fn fine(&self, t: Interval<Double>) -> Jet<Double> {
        jet(&self.fine, t)
    }
}

/// The zeros of what a line makes, for w from `low` to `high`.
pub(crate) fn zeros_between(line: &Line, made: &impl Made, low: f64, high: f64) -> Zeros {
    let both = Both { rough: made.made(&Beam::rough(line)), fine: made.made(&Beam::fine(line)) };
    zeros(&both, low, high)
}

/// The sensitivity of a hit whose surface moves as the coordinates of what makes it do.
pub(crate) fn moved(normal: [f64; 3], line: &Line, t: Double, reach: f64) -> Moved {
    let p = line.point(t).to_array();
    let size = line.room / (4.0 * f64::EPSILON) + reach;
    let by = normal.iter().zip(p).map(|(n, p)| n.abs() * (p.abs() + size)).sum();
    Moved { value: 0.0, by, slope: normal }
}
