//! Bracketed Newton on the monotone stretches of a polynomial (Yuksel, High Performance Graphics 2022).

use super::bracket::newton;
use super::descartes::{Search, each_isolated};
use super::unbounded::{bounds, unbounded};

/// The largest quotient of roots, as a power of two, with which they are looked for all at once.
const ALIKE: i32 = 10;

/// The real roots of a polynomial with at most `N` coefficients, ascending.
#[derive(Clone, Copy, Debug)]
pub struct Roots<const N: usize> {
    values: [f64; N],
    count: usize,
}

impl<const N: usize> Roots<N> {
    pub(super) fn new() -> Self {
        Self { values: [0.0; N], count: 0 }
    }

    /// Appends a root that is larger, if there is room.
    pub(super) fn push(&mut self, root: f64) {
        if let Some(place) = self.values.get_mut(self.count) {
            *place = root;
            self.count += 1;
        }
    }

    /// Appends roots that are larger, as far as there is room.
    pub(super) fn extend(&mut self, larger: impl Iterator<Item = f64>) {
        larger.for_each(|root| self.push(root));
    }

    /// The same roots in another unit; `change` must keep their order.
    pub fn map(mut self, change: impl Fn(f64) -> f64) -> Self {
        self.values[..self.count].iter_mut().for_each(|root| *root = change(*root));
        self
    }

    /// The roots.
    pub fn as_slice(&self) -> &[f64] {
        &self.values[..self.count]
    }
}

/// The distinct real roots in `[low, high]` of the polynomial whose `coefficients` start with the
/// constant; infinite ends are allowed. At most `N` coefficients count; none where all are zero or
/// one is not finite.
///
/// A simple root is exact to the last bits its coefficients determine, a double one to half of them.
pub fn roots_between<const N: usize>(coefficients: &[f64], low: f64, high: f64) -> Roots<N> {
    let mut roots = Roots::new();
    each_root::<N>(coefficients, [low, high], [low, high], &mut |root| {
        roots.push(root);
        true
    });
    roots
}

/// Calls back with the roots that [`roots_between`] the ends gives, ascending, until that returns `false`;
/// whether it never did. Those outside of what is `wanted` may be left out, which spares their search.
pub fn each_root<const N: usize>(
    coefficients: &[f64],
    [low, high]: [f64; 2],
    wanted: [f64; 2],
    found: &mut dyn FnMut(f64) -> bool,
) -> bool {
    let coefficients = trimmed(coefficients);
    if coefficients.len() < 2
        || coefficients.len() > N
        || low.is_nan()
        || high.is_nan()
        || low > high
        || !coefficients.iter().all(|c| c.is_finite())
    {
        return true;
    }
    if low == f64::NEG_INFINITY || high == f64::INFINITY {
        return match bounds(coefficients) {
            // Bernstein's coefficients tell apart what is not much closer to each other than to 0.
            (least, most) if most - least <= ALIKE => {
                let bound = 2f64.powi(most);
                let (low, high) = (low.max(-bound), high.min(bound));
                low > high || each_within::<N>(coefficients, [low, high], wanted, found)
            }
            _ => unbounded::<N>(coefficients, low, high).as_slice().iter().all(|root| found(*root)),
        };
    }
    each_within::<N>(coefficients, [low, high], wanted, found)
}

/// Without leading coefficients that are 0.
pub(super) fn trimmed(coefficients: &[f64]) -> &[f64] {
    &coefficients[..coefficients.iter().rposition(|c| *c != 0.0).map_or(0, |last| last + 1)]
}

/// All roots in a finite interval, of a polynomial without a leading zero.
pub(super) fn roots_within<const N: usize>(coefficients: &[f64], low: f64, high: f64) -> Roots<N> {
    let mut roots = Roots::new();
    each_within::<N>(coefficients, [low, high], [low, high], &mut |root| {
        roots.push(root);
        true
    });
    roots
}

/// As [`each_root`], in a finite interval and of a polynomial without a leading zero.
fn each_within<const N: usize>(
    c: &[f64],
    ends: [f64; 2],
    wanted: [f64; 2],
    found: &mut dyn FnMut(f64) -> bool,
) -> bool {
    let search = match c.len() {
        0 | 1 => Search::Done,
        2 => each_isolated::<2>(c, ends, wanted, found),
        3 => each_isolated::<3>(c, ends, wanted, found),
        4 => each_isolated::<4>(c, ends, wanted, found),
        5 => each_isolated::<5>(c, ends, wanted, found),
        6 => each_isolated::<6>(c, ends, wanted, found),
        7 => each_isolated::<7>(c, ends, wanted, found),
        8 => each_isolated::<8>(c, ends, wanted, found),
        9 => each_isolated::<9>(c, ends, wanted, found),
        _ => Search::Doubt(ends[0]),
    };
    match search {
        Search::Done => true,
        Search::Stopped => false,
        Search::Doubt(from) => {
            by_derivatives::<N>(c, from, ends[1]).as_slice().iter().all(|root| found(*root))
        }
    }
}

/// The same by way of all derivatives: slower, but sound where roots are multiple or nearly so.
fn by_derivatives<const N: usize>(coefficients: &[f64], low: f64, high: f64) -> Roots<N> {
    let length = coefficients.len();
    // The k-th derivative divided by k!, from the last one that is linear down to the polynomial itself:
    // the roots of each are the ends of the next one's monotone stretches.
    let degree = length - 1;
    let mut derivative = [0.0; N];
    let mut ends = Roots::<N>::new();
    for order in (0..degree).rev() {
        scaled_derivative(coefficients, order, &mut derivative);
        ends = stretch_roots(&derivative[..length - order], low, high, &ends);
    }
    ends
}

/// Coefficients of the `order`-th derivative over `order!`.
fn scaled_derivative<const N: usize>(coefficients: &[f64], order: usize, out: &mut [f64; N]) {
    let mut binomial = 1.0;
    for (i, c) in coefficients[order..].iter().enumerate() {
        out[i] = binomial * c;
        binomial = binomial * (i + order + 1) as f64 / (i + 1) as f64;
    }
}

/// Roots in `[low, high]` of a polynomial that is monotone between neighbouring `ends`.
fn stretch_roots<const N: usize>(c: &[f64], low: f64, high: f64, ends: &Roots<N>) -> Roots<N> {
    let mut roots = Roots::new();
    let mut from = (low, value(c, low));
    if from.1 == 0.0 {
        roots.push(low);
    }
    for &x in ends.as_slice() {
        if x <= from.0 || x >= high {
            continue;
        }
        let to = (x, value_above_noise(c, x));
        if let Some(root) = bracketed(c, from, to) {
            roots.push(root);
        }
        if to.1 == 0.0 {
            roots.push(x);
        }
        from = to;
    }
    let to = (high, value(c, high));
    if let Some(root) = bracketed(c, from, to) {
        roots.push(root);
    }
    if to.1 == 0.0 && high > low {
        roots.push(high);
    }
    roots
}

#[inline(always)]
pub(super) fn value(c: &[f64], x: f64) -> f64 {
    // Loops are unrolled where the length is known, closures are not.
    let (mut sum, mut i) = (0.0, c.len());
    while i > 0 {
        i -= 1;
        sum = sum * x + c[i];
    }
    sum
}

#[inline(always)]
pub(super) fn value_and_slope(c: &[f64], x: f64) -> (f64, f64) {
    let (mut value, mut slope, mut i) = (0.0, 0.0, c.len());
    while i > 0 {
        i -= 1;
        slope = slope * x + value;
        value = value * x + c[i];
    }
    (value, slope)
}

/// The value, or zero where its sign is lost in the rounding of coefficients and evaluation.
pub(super) fn value_above_noise(c: &[f64], x: f64) -> f64 {
    let (value, size) =
        c.iter().rev().fold((0.0, 0.0), |(v, s): (f64, f64), c| (v * x + c, s * x.abs() + c.abs()));
    if value.abs() <= 4.0 * f64::EPSILON * size { 0.0 } else { value }
}

/// The root of the polynomial with the coefficients `c` in a bracket with values of opposite sign at its ends,
/// each an argument with its value.
#[inline(always)]
pub fn bracketed(c: &[f64], from: (f64, f64), to: (f64, f64)) -> Option<f64> {
    newton(
        from,
        to,
        #[inline(always)]
        |x| value_and_slope(c, x),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roots(c: &[f64]) -> Vec<f64> {
        roots_between::<8>(c, f64::NEG_INFINITY, f64::INFINITY).as_slice().to_vec()
    }

    #[track_caller]
    fn close(found: &[f64], expected: &[f64], error: f64) {
        assert_eq!(found.len(), expected.len(), "{found:?} is not {expected:?}");
        for (f, e) in found.iter().zip(expected) {
            assert!((f - e).abs() <= error * e.abs().max(1e-300), "{found:?} is not {expected:?}");
        }
    }

    #[test]
    fn four_simple_roots_come_out_to_the_last_bits() {
        close(&roots(&[24.0, -50.0, 35.0, -10.0, 1.0]), &[1.0, 2.0, 3.0, 4.0], 1e-14);
    }

    #[test]
    fn double_roots_count_once() {
        close(&roots(&[1.0, 0.0, -2.0, 0.0, 1.0]), &[-1.0, 1.0], 1e-14);
        close(&roots(&[2.0, -3.0, 0.0, 1.0]), &[-2.0, 1.0], 1e-14);
        // x² (x² - 1)²
        let found = roots(&[0.0, 0.0, 1.0, 0.0, -2.0, 0.0, 1.0]);
        assert_eq!(found.len(), 3, "{found:?}");
    }

    #[test]
    fn scale_of_argument_and_value_changes_nothing() {
        for exponent in [-40, -8, 0, 8, 40] {
            let s = 10f64.powi(exponent);
            let c = [24.0 * s * s * s * s, -50.0 * s * s * s, 35.0 * s * s, -10.0 * s, 1.0];
            close(&roots(&c), &[s, 2.0 * s, 3.0 * s, 4.0 * s], 1e-14);
            close(&roots(&c.map(|c| c * 1e-30)), &[s, 2.0 * s, 3.0 * s, 4.0 * s], 1e-14);
        }
    }

    #[test]
    fn a_tiny_leading_coefficient_costs_no_digit_of_the_others() {
        let found = roots(&[-1.0, 1.0, 0.0, 0.0, 1e-8]);
        assert_eq!(found.len(), 2);
        assert!((found[1] - 0.999_999_990_000_000_4).abs() < 1e-15, "{found:?}");
    }

    #[test]
    fn coefficients_of_all_sizes_leave_every_root_to_be_found() {
        // A root near 1 of each, and one that a tiny leading coefficient puts far away.
        for degree in [3, 7, 15] {
            for exponent in [-20, -42, -150, -300] {
                let lead = 10f64.powi(exponent);
                let mut c = [0.0; 16];
                (c[0], c[degree - 1], c[degree]) = (-2.0, 1.0, lead);
                let found = roots_between::<16>(&c, f64::NEG_INFINITY, f64::INFINITY);
                let near = 2f64.powf(1.0 / (degree - 1) as f64);
                close(found.as_slice(), &[-1.0 / lead, -near, near], 1e-14);
                let ahead = roots_between::<16>(&c, 0.0, f64::INFINITY);
                close(ahead.as_slice(), &[near], 1e-14);
            }
        }
        // (x - 1)(x - 1e90)(x + 1e-90)
        close(&roots(&[1.0, 1e90, -1e90, 1.0]), &[-1e-90, 1.0, 1e90], 1e-14);
    }

    #[test]
    fn the_range_is_respected_and_its_ends_belong_to_it() {
        let c = [24.0, -50.0, 35.0, -10.0, 1.0];
        close(roots_between::<5>(&c, 1.5, 3.5).as_slice(), &[2.0, 3.0], 1e-14);
        close(roots_between::<5>(&c, 2.0, 3.0).as_slice(), &[2.0, 3.0], 1e-14);
        assert!(roots_between::<5>(&c, 5.0, 4.0).as_slice().is_empty());
    }

    #[test]
    fn what_is_no_polynomial_has_no_roots() {
        assert!(roots(&[]).is_empty());
        assert!(roots(&[1.0]).is_empty());
        assert!(roots(&[0.0, 0.0]).is_empty());
        assert!(roots(&[f64::NAN, 1.0]).is_empty());
        assert!(roots(&[1.0, f64::INFINITY]).is_empty());
    }
}
