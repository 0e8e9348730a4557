//! Real roots of polynomials, to the last bits and without absolute tolerances.
//!
//! Two roots closer than the rounding of the polynomial's value can tell apart count as one, at the
//! extremum between them: that is what makes a tangent ray one hit.

mod bracket;
mod descartes;
mod four;
mod polynomial;
mod unbounded;

pub use bracket::{between, newton};
pub use descartes::{Search, any_between, any_told_apart, each_told_apart};
pub use four::first_of_four;
pub use polynomial::{Roots, bracketed, each_root, roots_between};

/// `a b - c d` with an error below 2 units in the last place (Kahan; Jeannerod et al. 2013).
#[inline]
pub fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    (a.mul_add(b, -cd)) + (-c).mul_add(d, cd)
}

/// The real roots of `a t² + 2 b t + c` in ascending order; equal ones for a double root.
///
/// `None` where there is none, or where every `t` is one. A linear equation gives its root and an
/// infinity of the sign in which the second root was lost.
#[inline]
pub fn quadratic(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    with_discriminant(a, b, c, difference_of_products(b, b, a, c))
}

/// As [`quadratic`], where the caller knows a better way to the discriminant `b² - a c`.
#[inline(always)]
pub fn with_discriminant(a: f64, b: f64, c: f64, discriminant: f64) -> Option<[f64; 2]> {
    if a == 0.0 && b == 0.0 || discriminant.is_nan() || discriminant < 0.0 {
        return None;
    }
    // -b and the root's sign are added, never subtracted; the other root comes from the product c / a.
    let a = a + 0.0; // a negative zero would turn the infinity around
    let q = -(b + discriminant.sqrt().copysign(b));
    let (one, other) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    Some(if one < other { [one, other] } else { [other, one] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_roots_survive_beside_large_ones() {
        let [small, large] = quadratic(1.0, -0.5e8, 1.0).unwrap();
        assert_eq!([small, large], [1e-8, 1e8]);
    }

    #[test]
    fn the_discriminant_keeps_its_digits_near_double_roots() {
        // (t - 1)(t - 1 - 2^-29): b² - a c is 2^-60, lost in plain arithmetic.
        let gap = 2f64.powi(-29);
        let [low, high] = quadratic(1.0, -(1.0 + gap / 2.0), 1.0 + gap).unwrap();
        assert_eq!([low, high], [1.0, 1.0 + gap]);
    }

    #[test]
    fn linear_and_constant_equations_are_no_special_case_for_callers() {
        assert_eq!(quadratic(0.0, -1.0, 4.0), Some([2.0, f64::INFINITY]));
        assert_eq!(quadratic(0.0, 1.0, 4.0), Some([f64::NEG_INFINITY, -2.0]));
        assert_eq!(quadratic(0.0, 0.0, 0.0), None);
        assert_eq!(quadratic(1.0, 0.0, 0.0), Some([0.0, 0.0]));
        assert_eq!(quadratic(1.0, f64::NAN, 0.0), None);
    }
}
