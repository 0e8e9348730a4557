//! Polynomials over a range, in the form that Bernstein gave them: where their zeros are shows in signs.

use std::ops::{Add, Mul, Neg, Sub};

use crate::certify::{Cell, Limits};
use crate::curve::{Poly, plus, times};
use crate::interval::{Interval, Scalar};
use crate::real::Ring;

/// A sum of c uⁱ (1 - u)ⁿ⁻ⁱ over a degree n, for u from 0 to 1: products multiply as powers of one variable do.
#[derive(Clone)]
pub(crate) struct Form<S>(Poly<S>);

impl<S: Scalar> Form<S> {
    /// What goes straight from one number to another.
    pub(crate) fn line(from: Interval<S>, to: Interval<S>) -> Self {
        Self(vec![from, to])
    }

    fn degree(&self) -> usize {
        self.0.len() - 1
    }

    /// The same as one of a higher degree: times (u + 1 - u) to a power.
    fn raised(&self, degree: usize) -> Poly<S> {
        match degree - self.degree() {
            0 => self.0.clone(),
            more => times(&self.0, &binomials(more).map(Interval::of).collect()),
        }
    }

    /// Bernstein's coefficients: the polynomial is between the least and the greatest of them, and changes its
    /// sign at most as often as they do.
    pub(crate) fn coefficients(self) -> Poly<S> {
        let binomials = binomials(self.degree());
        self.0.into_iter().zip(binomials).map(|(c, count)| c / Interval::of(count)).collect()
    }
}

/// The numbers of ways to choose 0, 1, … of n.
fn binomials(n: usize) -> impl Iterator<Item = f64> {
    (0..=n).scan(1.0, move |next, i| {
        let here = *next;
        *next = here * (n - i) as f64 / (i + 1) as f64;
        Some(here)
    })
}

impl<S: Scalar> Add for Form<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let degree = self.degree().max(other.degree());
        Self(plus(&self.raised(degree), &other.raised(degree)))
    }
}

impl<S: Scalar> Neg for Form<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.into_iter().map(|c| -c).collect())
    }
}

impl<S: Scalar> Sub for Form<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<S: Scalar> Mul for Form<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(times(&self.0, &other.0))
    }
}

impl<S: Scalar> Ring for Form<S> {
    fn of(x: f64) -> Self {
        Self(vec![Interval::of(x)])
    }

    fn over(self, divisor: f64) -> Self {
        Self(self.0.into_iter().map(|c| c / Interval::of(divisor)).collect())
    }
}

/// Whether all numbers are on the same side of zero, for sure.
fn agree<S: Scalar>(mut numbers: impl Iterator<Item = Interval<S>> + Clone) -> bool {
    numbers.clone().all(Interval::is_positive) || numbers.all(Interval::is_negative)
}

/// The coefficients over the first half and over the second (de Casteljau).
fn halves<S: Scalar>(mut second: Poly<S>) -> [Poly<S>; 2] {
    let half = S::of(0.5);
    let mut first = Vec::with_capacity(second.len());
    for last in (0..second.len()).rev() {
        first.push(second[0]);
        for i in 0..last {
            let sum = second[i] + second[i + 1];
            second[i] = Interval { low: sum.low * half, high: sum.high * half };
        }
    }
    [first, second]
}

/// A part is worked out anew when it has come down to this share of what it was halved from.
const ANEW: f64 = 1.0 / 64.0;

/// Splits a range until every part is known, or a limit is met: `whole` is the form over all of it, `over` gives
/// those over its parts.
pub(crate) fn isolate<S: Scalar>(
    whole: Form<S>,
    over: impl Fn(Interval<S>) -> Form<S>,
    range: Interval<S>,
    Limits { least, most, anew }: Limits,
    found: &mut dyn FnMut(Cell<S>),
) {
    let width = |part: Interval<S>| (part.high - part.low).to_f64();
    let mut rest = vec![(range, whole.coefficients(), width(range))];
    let mut parts = 0;
    while let Some((part, coefficients, source)) = rest.pop() {
        if agree(coefficients.iter().copied()) {
            continue;
        }
        parts += 1;
        let (first, last) = (coefficients[0], coefficients[coefficients.len() - 1]);
        let ends_known = !first.has_zero() && !last.has_zero();
        if ends_known && agree(coefficients.windows(2).map(|pair| pair[1] - pair[0])) {
            if first.is_negative() != last.is_negative() {
                found(Cell::One { part, rising: first.is_negative() });
            }
            continue;
        }
        let middle = part.middle();
        let is_last = parts > most || width(part) <= least || middle <= part.low || middle >= part.high;
        // All of it is rounding, which no splitting takes away; but it is less where numbers are small.
        let is_rounding = coefficients.iter().all(|c| c.has_zero());
        if anew && is_rounding && !is_last && width(part) <= ANEW * source {
            rest.push((part, over(part).coefficients(), width(part)));
        } else if is_rounding || is_last {
            found(Cell::Doubt(part));
        } else {
            let [before, after] = halves(coefficients);
            rest.push((Interval { low: middle, ..part }, after, source));
            rest.push((Interval { high: middle, ..part }, before, source));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double::Double;

    /// (x - 1)(x - 2)(x² + 1) over a range.
    fn over<S: Scalar>(range: Interval<S>) -> Form<S> {
        let x = Form::line(Interval::point(range.low), Interval::point(range.high));
        x.clone().plus(-1.0) * x.clone().plus(-2.0) * x.square().plus(1.0)
    }

    fn cells<S: Scalar>(low: f64, high: f64) -> (Vec<(f64, f64, bool)>, usize) {
        let (mut ones, mut doubts) = (Vec::new(), 0);
        let range = Interval { low: S::of(low), high: S::of(high) };
        isolate(over(range), over, range, Limits { least: 1e-9, most: 1000, anew: true }, &mut |cell| {
            match cell {
                Cell::One { part, rising } => ones.push((part.low.to_f64(), part.high.to_f64(), rising)),
                Cell::Doubt(_) => doubts += 1,
            }
        });
        (ones, doubts)
    }

    #[test]
    fn every_zero_is_in_a_part_of_its_own() {
        for (ones, doubts) in [cells::<f64>(-3.0, 4.1), cells::<Double>(-3.0, 4.1)] {
            let [(a, b, false), (c, d, true)] = ones[..] else { panic!("{ones:?}") };
            assert!(a < 1.0 && 1.0 < b && b <= c && c < 2.0 && 2.0 < d, "{ones:?}");
            assert_eq!(doubts, 0);
        }
        assert_eq!(cells::<f64>(-3.0, 0.9), (Vec::new(), 0));
    }
}
