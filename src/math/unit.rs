//! Vectors brought to length 1.

use super::DVec3;

/// The bits of 1.
const ONE: i64 = 1.0_f64.to_bits() as i64;

/// `DVec3::normalize_or_zero`, to the bit. What has length 1 already but for rounding, as normals mostly have that are
/// normalised again, waits neither for a root nor for a division.
#[inline]
pub fn unit(v: DVec3) -> DVec3 {
    match inverse_root_near_one(v.length_squared()) {
        Some(factor) => v * factor,
        None => v.normalize_or_zero(),
    }
}

/// `1 / √x`, rounded twice, of a number next to 1. The root is half as many steps from 1 as x is, the inverse as far on the
/// other side; steps above 1 are twice as wide as those below. What would fall in the middle between two numbers is a
/// little less for a root and a little more for an inverse, because both curves bend, and is rounded that way.
#[inline]
fn inverse_root_near_one(x: f64) -> Option<f64> {
    /// So few that no bend comes to half a step.
    const NEAR: i64 = 64;
    let steps = x.to_bits() as i64 - ONE;
    if !(-NEAR..=NEAR).contains(&steps) {
        return None;
    }
    let bits = if steps >= 0 {
        ONE - 2 * (steps >> 1)
    } else {
        let down = (1 - steps) >> 1;
        ONE + ((down + 1) >> 1)
    };
    Some(f64::from_bits(bits as u64))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;

    #[test]
    fn inverse_roots_next_to_one_are_rounded_as_ever() {
        for steps in -64..=64 {
            let x = f64::from_bits((ONE + steps) as u64);
            assert_eq!(inverse_root_near_one(x), Some(x.sqrt().recip()), "{x:?}");
        }
        for x in [0.0, -1.0, 0.99, 1.01, f64::NAN, f64::INFINITY] {
            assert_eq!(inverse_root_near_one(x), None);
        }
    }

    #[test]
    fn vectors_are_normalised_as_ever() {
        let mut number = numbers(5);
        for turn in 0..10_000 {
            let v = DVec3::new(number(), number(), number()) * if turn % 2 == 0 { 1.0 } else { 1e3 };
            for v in [v, v.normalize_or_zero(), v.normalize_or_zero() * 0.2] {
                assert_eq!(unit(v), v.normalize_or_zero());
            }
        }
        assert_eq!(unit(DVec3::ZERO), DVec3::ZERO);
    }
}
