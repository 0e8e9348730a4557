//! A root of any function between two points where its signs differ.

/// The root between `from` and `to`, each an argument with its value, of what has the value and slope that
/// `value` gives and rises or falls all the way; `None` where the signs at the ends don't differ.
///
/// Newton's method, with bisection where it would leave the bracket or does not halve its step.
#[inline(always)]
pub fn newton(from: (f64, f64), to: (f64, f64), value: impl Fn(f64) -> (f64, f64)) -> Option<f64> {
    if from.1 == 0.0 || to.1 == 0.0 || (from.1 < 0.0) == (to.1 < 0.0) {
        return None;
    }
    let (mut low, mut high) = (from.0, to.0);
    let rising = from.1 < 0.0;
    let width = high - low;
    // Where the chord crosses, but not at an end: roots there are found as fast from anywhere.
    let share = (from.1 / (from.1 - to.1)).clamp(1.0 / 64.0, 63.0 / 64.0);
    let mut x = low + width * if share.is_nan() { 0.5 } else { share };
    let (mut last_step, mut was_newton) = (width, false);
    loop {
        let (height, slope) = value(x);
        if height == 0.0 {
            return Some(x);
        }
        if (height < 0.0) == rising {
            low = x;
        } else {
            high = x;
        }
        let fine = f64::EPSILON * 0.5 * x.abs();
        let mut next = x - height / slope;
        let step = (next - x).abs();
        // A step out of the bracket, or one that doesn't halve the last, gives way to bisection.
        let is_newton = next > low && next < high && step <= 0.5 * last_step;
        if is_newton {
            // What is left is to this step as its square to that of the last: less than anything can tell.
            if was_newton && step * step * step <= fine * last_step * last_step {
                return Some(next);
            }
        } else {
            next = low + (high - low) * 0.5;
        }
        was_newton = is_newton;
        last_step = (next - x).abs();
        if last_step <= fine || next <= low || next >= high {
            return Some(next);
        }
        x = next;
    }
}

/// The root between `from` and `to`, each an argument with its value, to the last bits, of any continuous
/// function.
///
/// Chandrupatla's method: inverse quadratic interpolation where it can be trusted, else bisection.
/// Zero counts as negative.
pub fn between(from: (f64, f64), to: (f64, f64), value: impl Fn(f64) -> f64) -> f64 {
    /// Each three steps at least halve the bracket twice; this covers every exponent there is.
    const STEPS: usize = 400;
    let (mut a, mut b) = (from, to);
    let mut share = 0.5;
    for _ in 0..STEPS {
        let x = a.0 + share * (b.0 - a.0);
        let new = (x, value(x));
        // `c` is what is left behind; `a` and `b` enclose the root.
        let c;
        if (new.1 > 0.0) == (a.1 > 0.0) {
            (c, a) = (a, new);
        } else {
            (c, b, a) = (b, a, new);
        }
        let best = if a.1.abs() < b.1.abs() { a } else { b };
        let width = b.0 - a.0;
        let least = 0.5 * f64::EPSILON * best.0.abs() / width.abs();
        if best.1 == 0.0 || least.is_nan() || least > 0.5 || a.0 + 0.5 * width == a.0 {
            return best.0;
        }
        let place = (a.0 - b.0) / (c.0 - b.0);
        let height = (a.1 - b.1) / (c.1 - b.1);
        let trusted = height * height < place && (1.0 - height) * (1.0 - height) < 1.0 - place;
        share = if trusted {
            a.1 / (b.1 - a.1) * c.1 / (b.1 - c.1)
                + (c.0 - a.0) / width * a.1 / (c.1 - a.1) * b.1 / (c.1 - b.1)
        } else {
            0.5
        };
        share = share.clamp(least, 1.0 - least);
    }
    a.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(low: f64, high: f64, value: impl Fn(f64) -> f64) -> f64 {
        between((low, value(low)), (high, value(high)), value)
    }

    #[test]
    fn smooth_and_steep_functions_are_solved_to_the_last_bits() {
        assert!((root(0.0, 2.0, |x| x * x - 2.0) - 2f64.sqrt()).abs() < 1e-15);
        assert!((root(0.0, 10.0, |x| x.powi(9) - 1e-9) - 0.1).abs() < 1e-16);
        assert!((root(-1.0, 3.0, |x| (x - 0.3).cbrt()) - 0.3).abs() < 1e-15);
        assert!((root(0.0, 1.0, |x| if x < 0.7 { -1.0 } else { 1.0 }) - 0.7).abs() < 1e-15);
    }

    #[test]
    fn few_evaluations_are_needed() {
        let count = std::cell::Cell::new(0);
        root(0.0, 2.0, |x| {
            count.set(count.get() + 1);
            x * x * x - x - 1.0
        });
        assert!(count.get() < 16, "{}", count.get());
    }

    #[test]
    fn an_end_that_is_zero_is_the_root() {
        assert_eq!(root(0.0, 1.0, |x| x), 0.0);
        assert_eq!(root(-1.0, 0.0, |x| -x), 0.0);
    }
}
