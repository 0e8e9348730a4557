//! The first roots of four polynomials side by side: the operations of [`each_told_apart`](super::each_told_apart) in its
//! order, so the same bits.

use crate::math::Lanes;

/// Terms of polynomials of degree 4.
const TERMS: usize = 5;

/// Brackets that so many steps don't close are left to who takes them one by one.
const STEPS: u32 = 24;

/// 1 for yes, 0 for no.
#[inline(always)]
fn flag(yes: bool) -> f64 {
    if yes { 1.0 } else { 0.0 }
}

/// How often signs change among Bernstein coefficients, and the least of their sizes.
#[inline(always)]
fn changes(b: &[Lanes; TERMS]) -> (Lanes, Lanes) {
    let (mut changes, mut least) = (Lanes::ZERO, b[0].abs());
    for i in 1..TERMS {
        changes = changes + b[i - 1].zip(b[i], |a, b| flag((a < 0.0) != (b < 0.0)));
        least = b[i].abs().lesser(least);
    }
    (changes, least)
}

/// The least roots of four polynomials of degree 4 between `low` and `high`, given their Bernstein coefficients there,
/// each known up to `noise`: infinite for none, no number where that takes a closer look. `value` gives values and
/// slopes.
#[inline(always)]
pub fn first_of_four(
    b: &[Lanes; TERMS],
    noise: Lanes,
    [low, high]: [Lanes; 2],
    value: impl Fn(Lanes) -> (Lanes, Lanes),
) -> Lanes {
    let (all, least) = changes(b);
    let rootless = all.zip(least - noise, |changes, above| flag(changes == 0.0 && above > 0.0));
    // One root is looked for on all of the way, the first of two before the side on which the coefficients are
    // farthest beyond zero.
    let (mut farthest, mut share) = (b[1] * b[0], Lanes::splat(0.25));
    for (i, place) in [(2, 0.5), (3, 0.75)] {
        let beyond = b[i] * b[0];
        let farther = beyond.zip(farthest, |a, b| flag(a < b));
        farthest = beyond.where_positive(farther, farthest);
        share = Lanes::splat(place).where_positive(farther, share);
    }
    let share = share.zip(all, |share, changes| if changes == 1.0 { 1.0 } else { share });
    let rest = -share + 1.0;
    let (mut left, mut right) = (*b, *b);
    for (i, first) in left.iter_mut().enumerate() {
        *first = right[0];
        for j in 0..TERMS - 1 - i {
            right[j] = rest * right[j] + share * right[j + 1];
        }
    }
    let (first, least) = changes(&left);
    let lost = b[0].abs().lesser(b[TERMS - 1].abs());
    let told = first.zip(all, |first, all| flag(first == 1.0 && (all == 1.0 || all == 2.0)));
    let told = told.where_positive(least.lesser(lost) - noise, Lanes::ZERO);
    let end = low + (high - low) * share;
    let root = newton([low, left[0]], [end, left[TERMS - 1]], told, value);
    Lanes::splat(f64::INFINITY).where_positive(rootless, root)
}

/// [`newton`](super::newton) where that is `wanted`; no number elsewhere.
#[inline(always)]
fn newton(
    from: [Lanes; 2],
    to: [Lanes; 2],
    mut wanted: Lanes,
    value: impl Fn(Lanes) -> (Lanes, Lanes),
) -> Lanes {
    let (mut low, mut high) = (from[0], to[0]);
    let width = high - low;
    let share =
        (from[1] / (from[1] - to[1])).greater(Lanes::splat(1.0 / 64.0)).lesser(Lanes::splat(63.0 / 64.0));
    let mut x = low + width * share;
    let (mut last_step, mut was_newton) = (width, Lanes::ZERO);
    let mut root = Lanes::splat(f64::NAN);
    for _ in 0..STEPS {
        if wanted.bits(|wanted| wanted > 0.0) == 0 {
            break;
        }
        let (height, slope) = value(x);
        let below = height.zip(from[1], |height, from| flag((height < 0.0) == (from < 0.0)));
        low = x.where_positive(below, low);
        high = high.where_positive(below, x);
        let fine = x.abs() * (f64::EPSILON * 0.5);
        let next = x - height / slope;
        let step = (next - x).abs();
        let within = next.zip(low, |next, low| flag(next > low));
        let within = within.where_positive(next.zip(high, |next, high| flag(next < high)), Lanes::ZERO);
        let halved = step.zip(last_step * 0.5, |step, half| flag(step <= half));
        let is_newton = within.where_positive(halved, Lanes::ZERO);
        let settled = (step * step * step).zip(fine * last_step * last_step, |a, b| flag(a <= b));
        let settled = settled.where_positive(is_newton, Lanes::ZERO).where_positive(was_newton, Lanes::ZERO);
        let next = next.where_positive(is_newton, low + (high - low) * 0.5);
        last_step = (next - x).abs();
        let short = last_step.zip(fine, |step, fine| flag(step <= fine));
        let closed =
            next.zip(low, |next, low| flag(next <= low)) + next.zip(high, |next, high| flag(next >= high));
        let zero = height.map(|height| flag(height == 0.0));
        let done = (settled + short + closed + zero).where_positive(wanted, Lanes::ZERO);
        root = x.where_positive(zero, next).where_positive(done, root);
        wanted = Lanes::ZERO.where_positive(done, wanted);
        (was_newton, x) = (is_newton, next);
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;
    use crate::math::roots::{Search, each_told_apart};

    /// The value and slope of a polynomial in Bernstein's form between 0 and 1, in powers.
    fn powers([p, q, r, s, t]: [f64; TERMS]) -> [f64; TERMS] {
        [
            p,
            4.0 * (q - p),
            6.0 * (r - 2.0 * q + p),
            4.0 * (s - 3.0 * (r - q) - p),
            t - 4.0 * (s + q) + 6.0 * r + p,
        ]
    }

    #[test]
    fn four_first_roots_have_the_bits_of_each_alone() {
        let mut number = numbers(31);
        let mut seen = [0; 3];
        for _ in 0..20_000 {
            let all = [0; Lanes::COUNT].map(|_| [0; TERMS].map(|_| number() + 0.3));
            let (mut b, mut c) = ([Lanes::ZERO; TERMS], [Lanes::ZERO; TERMS]);
            for (lane, one) in all.iter().enumerate() {
                let powers = powers(*one);
                for i in 0..TERMS {
                    (b[i].0[lane], c[i].0[lane]) = (one[i], powers[i]);
                }
            }
            let [e, d, f, g, a] = c;
            let value = |t: Lanes| {
                let height = e + t * (d + t * (f + t * (g + t * a)));
                (height, d + t * (f * 2.0 + t * (g * 3.0 + t * a * 4.0)))
            };
            let found = first_of_four(&b, Lanes::splat(1e-12), [Lanes::ZERO, Lanes::splat(1.0)], value);
            for (lane, one) in all.iter().enumerate() {
                let mut first = f64::INFINITY;
                let search = each_told_apart(
                    one,
                    1e-12,
                    [0.0, 1.0],
                    [0.0, 1.0],
                    |t| {
                        let (height, slope) = value(Lanes::splat(t));
                        (height.0[lane], slope.0[lane])
                    },
                    &mut |root| {
                        first = root;
                        false
                    },
                );
                let together = found.0[lane];
                let doubt = matches!(search, Search::Doubt(_));
                assert!(together.is_nan() || !doubt && together == first, "{one:?}: {together} {first}");
                seen[if together.is_nan() { 2 } else { usize::from(together.is_finite()) }] += 1;
            }
        }
        assert!(seen[0] > 20_000 && seen[1] > 15_000, "{seen:?}");
    }
}
