//! Roots told apart by the signs of Bernstein coefficients (Descartes' rule: no change of sign, no
//! root; one change, one root).

use smallvec::SmallVec;

use super::bracket::newton;
use super::polynomial::value_and_slope;

/// Intervals are divided at most this often to part neighbouring roots.
const HALVINGS: u32 = 10;

/// How a search for roots ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Search {
    /// All wanted roots were found.
    Done,
    /// Nobody wants more of them.
    Stopped,
    /// From here on rounding or roots close together leave doubt.
    Doubt(f64),
}

/// Calls back with the roots in `[low, high]` of a polynomial with the `L` coefficients `c`, as
/// [`each_root`](super::each_root) does.
pub(super) fn each_isolated<const L: usize>(
    c: &[f64],
    [low, high]: [f64; 2],
    wanted: [f64; 2],
    found: &mut dyn FnMut(f64) -> bool,
) -> Search {
    let Ok(c) = <&[f64; L]>::try_from(c) else {
        return Search::Doubt(low);
    };
    let width = high - low;
    let (b, noise) = bernstein(c, low, width);
    if !noise.is_finite() {
        return Search::Doubt(low);
    }
    each_told_apart(
        &b,
        noise,
        [low, high],
        wanted,
        #[inline(always)]
        |t| value_and_slope(c, t),
        found,
    )
}

/// Calls back with the roots of a polynomial in `[low, high]`, where it has the Bernstein coefficients `b`, each
/// known up to `noise`, as [`each_root`](super::each_root) does. `value` gives its value and slope.
#[inline(always)]
pub fn each_told_apart<const L: usize>(
    b: &[f64; L],
    noise: f64,
    [low, high]: [f64; 2],
    wanted: [f64; 2],
    value: impl Fn(f64) -> (f64, f64),
    found: &mut (impl FnMut(f64) -> bool + ?Sized),
) -> Search {
    // What comes after the stretch at hand, the next of it last.
    let mut later = SmallVec::<[_; HALVINGS as usize]>::new();
    let (mut b, mut halvings) = (*b, HALVINGS);
    let mut place = Stretch { low, width: high - low, from: 0.0, share: 1.0 };
    loop {
        let ends = [place.at(0.0), place.at(1.0)];
        if ends[0] > wanted[1] {
            return Search::Stopped;
        }
        let (mut changes, mut least) = (0, b[0].abs());
        for i in 1..L {
            changes += u32::from((b[i - 1] < 0.0) != (b[i] < 0.0));
            least = least.min(b[i].abs());
        }
        let certain = least > noise;
        let is_over = ends[1] < wanted[0] || certain && changes == 0;
        if !is_over {
            let is_lost = b[0].abs() <= noise || b[L - 1].abs() <= noise;
            if is_lost || halvings == 0 && !(certain && changes == 1) {
                return Search::Doubt(ends[0]);
            }
            if !(certain && changes == 1) {
                // Between two roots, if there are two, else anywhere: in the middle.
                let share = if changes == 2 { far_side(&b) } else { 0.5 };
                let (left, right) = divided(&b, share);
                let first = Stretch { share: share * place.share, ..place };
                let second =
                    Stretch { from: first.from + first.share, share: place.share - first.share, ..place };
                halvings -= 1;
                later.push((right, second, halvings));
                (b, place) = (left, first);
                continue;
            }
            match newton((ends[0], b[0]), (ends[1], b[L - 1]), &value) {
                Some(root) if found(root) => {}
                Some(_) => return Search::Stopped,
                None => return Search::Doubt(ends[0]),
            }
        }
        match later.pop() {
            Some(next) => (b, place, halvings) = next,
            None => return Search::Done,
        }
    }
}

/// How many times the rounding errors of its values a polynomial must rise beside a zero to be known
/// to have no other there.
const STEEP: f64 = 1e4;

/// Whether a polynomial with the coefficients `c` has a root between `low` and `high`; a zero at `low`
/// itself is none. `None` where rounding or roots close together leave doubt.
pub fn any_between<const L: usize>(c: &[f64; L], low: f64, high: f64) -> Option<bool> {
    let (b, noise) = bernstein(c, low, high - low);
    any_told_apart(b, noise)
}

/// The same of one that has the Bernstein coefficients `b`, each known up to `noise`.
#[inline(always)]
pub fn any_told_apart<const L: usize>(mut b: [f64; L], noise: f64) -> Option<bool> {
    if !noise.is_finite() {
        return None;
    }
    if b[0].abs() <= noise {
        // It leaves a zero at the start for one side.
        if b[1].abs() <= STEEP * noise {
            return None;
        }
        b[0] = noise.next_up().copysign(b[1]);
    }
    changes_sign(&b, noise, HALVINGS)
}

/// Whether a polynomial with the Bernstein coefficients `b` has a root; `None` where that is in doubt.
fn changes_sign<const L: usize>(b: &[f64; L], noise: f64, halvings: u32) -> Option<bool> {
    if b[L - 1].abs() <= noise {
        return None;
    }
    if (b[0] < 0.0) != (b[L - 1] < 0.0) {
        return Some(true);
    }
    let (mut alike, mut certain) = (true, true);
    for i in 1..L {
        alike &= (b[i] < 0.0) == (b[0] < 0.0);
        certain &= b[i].abs() > noise;
    }
    if alike && certain {
        return Some(false);
    }
    if halvings == 0 {
        return None;
    }
    let (left, right) = divided(b, far_side(b));
    match changes_sign(&left, noise, halvings - 1)? {
        true => Some(true),
        false => changes_sign(&right, noise, halvings - 1),
    }
}

/// The Bernstein coefficients of a polynomial between `low` and `low + width`, and a bound on their
/// rounding errors.
#[inline(always)]
fn bernstein<const L: usize>(c: &[f64; L], low: f64, width: f64) -> ([f64; L], f64) {
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
    let mut size = 0.0;
    for i in (0..L).rev() {
        size = size * reach + c[i].abs();
    }
    (b, 16.0 * (L - 1) as f64 * f64::EPSILON * size)
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
    #[inline(always)]
    fn at(&self, share: f64) -> f64 {
        self.low + self.width * (self.from + self.share * share)
    }
}

/// De Casteljau's division: the coefficients before and after a share of the way.
#[inline(always)]
fn divided<const L: usize>(b: &[f64; L], share: f64) -> ([f64; L], [f64; L]) {
    let (mut left, mut right) = ([0.0; L], *b);
    for (i, first) in left.iter_mut().enumerate() {
        *first = right[0];
        for j in 0..L - 1 - i {
            right[j] = (1.0 - share) * right[j] + share * right[j + 1];
        }
    }
    (left, right)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;
    use crate::math::roots::roots_between;

    #[test]
    fn whether_there_is_a_root_agrees_with_the_roots() {
        let mut number = numbers(5);
        let mut seen = [0; 3];
        for _ in 0..20_000 {
            let c: [f64; 5] = std::array::from_fn(|_| number());
            let (low, high) = (number(), number() + 1.0);
            let found = any_between(&c, low, high);
            let roots = roots_between::<5>(&c, low, high);
            assert!(found.is_none_or(|found| found != roots.as_slice().is_empty()), "{c:?} {low} {high}");
            seen[found.map_or(2, usize::from)] += 1;
        }
        assert!(seen[0] > 2000 && seen[1] > 2000 && seen[2] < 20, "{seen:?}");
    }

    #[test]
    fn a_zero_at_the_start_is_no_root() {
        // t (t - 2) and t (t + 2).
        assert_eq!(any_between(&[0.0, -2.0, 1.0], 0.0, 1.0), Some(false));
        assert_eq!(any_between(&[0.0, -2.0, 1.0], 0.0, 3.0), Some(true));
        assert_eq!(any_between(&[0.0, 2.0, 1.0], 0.0, 3.0), Some(false));
        assert_eq!(any_between(&[0.0, 0.0, 1.0], 0.0, 3.0), None);
    }
}
