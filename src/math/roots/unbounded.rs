//! Roots on a whole line: those near 0 as they are, those far from it as the roots of the reversed polynomial.
//!
//! A tiny leading coefficient puts a root so far away that powers of it overflow, and an interval that holds it
//! is too long for anything else to be told apart in it. Its inverse is as good a root as any.

use super::polynomial::{Roots, roots_within, trimmed, value_above_noise};

/// The power of two above a number that isn't 0.
fn exponent(c: f64) -> i32 {
    // Of what is too small for the exponent's bits, it is but above.
    ((c.to_bits() >> 52) & 0x7ff) as i32 - 1022
}

/// Added to differences of exponents to make them positive: without a sign they are divided faster.
const ABOVE: i32 = 1 << 13;

/// Powers of two: all roots but those at 0 are farther from it than the first and no farther than the second
/// (Fujiwara).
pub(super) fn bounds(c: &[f64]) -> (i32, i32) {
    let first = c.iter().take_while(|c| **c == 0.0).count();
    let Some(last) = c.iter().rposition(|c| *c != 0.0) else {
        return (0, 0);
    };
    let (low, high) = (exponent(c[first]), exponent(c[last]));
    // Exponents are above by up to 1, those divided by may be too small by as much; rounded up.
    let rate = |above: i32, length: usize| {
        let length = length as u32;
        (above.wrapping_add(ABOVE) as u32).wrapping_add(ABOVE as u32 * (length - 1) + length) / length
    };
    let (mut least, mut most) = (0, 0);
    for (i, c) in c.iter().enumerate().take(last + 1).skip(first) {
        if *c == 0.0 {
            continue;
        }
        let above = exponent(*c);
        if i < last {
            most = most.max(rate(above - high, last - i));
        }
        if i > first {
            least = least.max(rate(above - low, i - first));
        }
    }
    let settled = |rate: u32| if rate == 0 { 0 } else { rate as i32 - ABOVE };
    (-1 - settled(least), 1 + settled(most))
}

/// `x` times a power of two, where that is no number too large.
fn scaled(x: f64, exponent: i32) -> f64 {
    let half = exponent.max(-2000) / 2;
    x * 2f64.powi(half) * 2f64.powi(exponent.max(-2000) - half)
}

/// The roots between ends of which at least one is infinite.
pub(super) fn unbounded<const N: usize>(c: &[f64], low: f64, high: f64) -> Roots<N> {
    // In this unit there are roots on both sides of 1, if their sizes differ.
    let unit = middle_size(c);
    let sizes = || (0..).zip(c).filter(|(_, c)| **c != 0.0).map(|(i, c)| exponent(*c) + i * unit);
    let most = sizes().max().unwrap_or(0);
    let (mut near, mut far) = ([0.0; N], [0.0; N]);
    for (i, c) in c.iter().enumerate() {
        near[i] = scaled(*c, i as i32 * unit - most);
    }
    let (near, far) = (&mut near[..c.len()], &mut far[..c.len()]);
    far.copy_from_slice(near);
    far.reverse();
    // Where the sign is sure: no root is taken for one of both parts, or of none.
    let sure = |at: &f64| [-*at, *at].iter().all(|at| value_above_noise(near, *at) != 0.0);
    let border = [1.0, 1.25, 0.75, 1.5, 0.625, 1.75].into_iter().find(sure).unwrap_or(1.0);
    let [low, high] = [low, high].map(|end| scaled(end, -unit));
    let mut roots = Roots::<N>::new();
    let beyond = |from: f64, to: f64, roots: &mut Roots<N>| {
        if from < to {
            let found = roots_within::<N>(trimmed(far), 1.0 / to, 1.0 / from);
            roots.extend(found.as_slice().iter().rev().filter(|u| **u != 0.0).map(|u| 1.0 / u));
        }
    };
    beyond(low, high.min(-border), &mut roots);
    if low.max(-border) <= high.min(border) {
        let found = roots_within::<N>(trimmed(near), low.max(-border), high.min(border));
        roots.extend(found.as_slice().iter().copied());
    }
    beyond(low.max(border), high, &mut roots);
    roots.map(|root| scaled(root, unit))
}

/// The power of two of the size of roots of which half are smaller: the slope of the convex hull of the
/// coefficients' exponents (Newton's polygon) over the middle.
fn middle_size(c: &[f64]) -> i32 {
    let half = c.len() / 2;
    let known = || (0..).zip(c).filter(|(_, c)| **c != 0.0).map(|(i, c)| (i, exponent(*c)));
    let half = half as i32;
    let (mut best, mut slope) = (f64::NEG_INFINITY, 0.0);
    for (i, e) in known().filter(|(i, _)| *i < half) {
        for (j, f) in known().filter(|(j, _)| *j >= half) {
            let rise = f64::from(f - e) / f64::from(j - i);
            let height = f64::from(e) + rise * f64::from(half - i);
            if height > best {
                (best, slope) = (height, rise);
            }
        }
    }
    -slope.round() as i32
}
