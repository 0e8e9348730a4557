//! Roots told apart by the signs of Bernstein coefficients (Descartes' rule: no change of sign, no
//! root; one change, one root).

use super::polynomial::{Roots, bracketed};

/// Intervals are divided at most this often to part neighbouring roots.
const HALVINGS: u32 = 10;

/// The roots in `[low, high]` of a polynomial with the `L` coefficients `c`. `None` where rounding or
/// roots close together leave doubt.
pub(super) fn isolated<const L: usize, const N: usize>(c: &[f64], low: f64, high: f64) -> Option<Roots<N>> {
    let c: &[f64; L] = c.try_into().ok()?;
    let width = high - low;
    // The polynomial of the share of the way from low to high.
    let mut b = *c;
    for from in 0..L - 1 {
        for i in (from..L - 1).rev() {
            b[i] += low * b[i + 1];
        }
    }
    // In Bernstein's form: each coefficient over its binomial, then Pascal's sums.
    let (mut power, mut binomial) = (1.0, 1.0);
    for (i, b) in b.iter_mut().enumerate() {
        *b *= power / binomial;
        power *= width;
        binomial = binomial * (L - 1 - i) as f64 / (i + 1) as f64;
    }
    for from in 1..L {
        for i in (from..L).rev() {
            b[i] += b[i - 1];
        }
    }
    let reach = low.abs() + width;
    let size = c.iter().rev().fold(0.0, |sum, c| sum * reach + c.abs());
    let noise = 16.0 * (L - 1) as f64 * f64::EPSILON * size;
    if !noise.is_finite() {
        return None;
    }
    let mut roots = Roots::new();
    let place = Stretch { low, width, from: 0.0, share: 1.0 };
    isolate(c, &b, place, noise, HALVINGS, &mut roots).then_some(roots)
}

/// A part of an interval.
#[derive(Clone, Copy)]
struct Stretch {
    low: f64,
    width: f64,
    from: f64,
    share: f64,
}

impl Stretch {
    fn at(&self, share: f64) -> f64 {
        self.low + self.width * (self.from + self.share * share)
    }
}

/// Appends the roots on a stretch with the Bernstein coefficients `b`; whether all were told apart.
fn isolate<const L: usize, const N: usize>(
    c: &[f64; L],
    b: &[f64; L],
    place: Stretch,
    noise: f64,
    halvings: u32,
    roots: &mut Roots<N>,
) -> bool {
    if b[0].abs() <= noise || b[L - 1].abs() <= noise {
        return false;
    }
    let (mut changes, mut certain) = (0, true);
    for i in 1..L {
        changes += u32::from((b[i - 1] < 0.0) != (b[i] < 0.0));
        certain &= b[i].abs() > noise;
    }
    if certain && changes == 0 {
        return true;
    }
    if certain && changes == 1 {
        let Some(root) = bracketed(c, (place.at(0.0), b[0]), (place.at(1.0), b[L - 1])) else {
            return false;
        };
        roots.push(root);
        return true;
    }
    if halvings == 0 {
        return false;
    }
    // Between two roots, if there are two, else anywhere: in the middle.
    let share = if changes == 2 { far_side(b) } else { 0.5 };
    // De Casteljau's division.
    let (mut left, mut right) = ([0.0; L], *b);
    for (i, first) in left.iter_mut().enumerate() {
        *first = right[0];
        for j in 0..L - 1 - i {
            right[j] = (1.0 - share) * right[j] + share * right[j + 1];
        }
    }
    let first = Stretch { share: share * place.share, ..place };
    let second = Stretch { from: first.from + first.share, share: place.share - first.share, ..place };
    isolate(c, &left, first, noise, halvings - 1, roots)
        && isolate(c, &right, second, noise, halvings - 1, roots)
}

/// The share of the way at which the coefficients are farthest beyond zero, seen from the first one.
fn far_side<const L: usize>(b: &[f64; L]) -> f64 {
    let mut farthest = 1;
    for i in 2..L - 1 {
        if b[i] * b[0] < b[farthest] * b[0] {
            farthest = i;
        }
    }
    farthest as f64 / (L - 1) as f64
}
