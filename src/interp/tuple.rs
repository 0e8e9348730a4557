//! Numbers of one to five components and their arithmetic, docs/spec/language.md 3.2 and 3.3.

/// One to five components: a float, a vector or a color.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuple {
    /// How many components count, 1 to 5.
    pub n: u8,
    /// The components; zero beyond `n`.
    pub c: [f64; 5],
}

/// What counts as zero in comparisons.
const EPSILON: f64 = 1e-10;

/// Whether a number counts as true.
pub fn truth(value: f64) -> bool {
    value.abs() > EPSILON
}

impl Tuple {
    /// A single number.
    #[inline]
    pub fn float(value: f64) -> Tuple {
        Tuple { n: 1, c: [value, 0.0, 0.0, 0.0, 0.0] }
    }

    /// From one to five components.
    #[inline]
    pub fn new(components: &[f64]) -> Tuple {
        let mut c = [0.0; 5];
        let n = components.len().min(5);
        c[..n].copy_from_slice(&components[..n]);
        Tuple { n: n as u8, c }
    }

    /// The single number repeated in `n` components; longer tuples stay.
    #[inline]
    pub fn promoted(self, n: u8) -> Tuple {
        if self.n != 1 || n <= 1 {
            return self;
        }
        let mut c = [0.0; 5];
        c[..usize::from(n)].fill(self.c[0]);
        Tuple { n, c }
    }

    /// At least `n` components: a single number is repeated, other tuples get zeros.
    #[inline]
    pub fn padded(self, n: u8) -> Tuple {
        if self.n == 1 { self.promoted(n) } else { Tuple { n: self.n.max(n), ..self } }
    }

    /// Applies `f` to each component.
    #[inline]
    pub fn map(mut self, f: impl Fn(f64) -> f64) -> Tuple {
        for c in &mut self.c[..usize::from(self.n)] {
            *c = f(*c);
        }
        self
    }

    /// Applies `f` to the components of both, the shorter one promoted or padded.
    #[inline]
    pub fn zip(self, other: Tuple, f: impl Fn(f64, f64) -> f64) -> Tuple {
        if self.n == 1 && other.n == 1 {
            return Tuple::float(f(self.c[0], other.c[0]));
        }
        let n = self.n.max(other.n);
        let (a, b) = (self.promoted(n), other.promoted(n));
        let mut c = [0.0; 5];
        for (i, slot) in c[..usize::from(n)].iter_mut().enumerate() {
            *slot = f(a.c[i], b.c[i]);
        }
        Tuple { n, c }
    }

    /// The components that count.
    pub fn components(&self) -> &[f64] {
        &self.c[..usize::from(self.n)]
    }

    /// The brightness, `gray`.
    pub fn gray(&self) -> f64 {
        0.297 * self.c[0] + 0.589 * self.c[1] + 0.114 * self.c[2]
    }
}

/// `a / b`; anything over exactly zero is positive infinity.
#[inline]
pub fn divide(a: f64, b: f64) -> f64 {
    if b == 0.0 { f64::INFINITY } else { a / b }
}

/// Comparison and logic: 1 where it holds, else 0.
pub mod test {
    use super::{EPSILON, truth};

    fn number(holds: bool) -> f64 {
        f64::from(u8::from(holds))
    }

    /// Whether two numbers are told apart; what is no number is not.
    fn differ(a: f64, b: f64) -> bool {
        (a - b).abs() > EPSILON
    }

    /// `a = b`, within a hair's breadth.
    pub fn equal(a: f64, b: f64) -> f64 {
        number(!differ(a, b))
    }
    /// `a != b`.
    pub fn not_equal(a: f64, b: f64) -> f64 {
        number(differ(a, b))
    }
    /// `a < b`, exactly.
    pub fn less(a: f64, b: f64) -> f64 {
        number(a < b)
    }
    /// `a > b`, exactly.
    pub fn greater(a: f64, b: f64) -> f64 {
        number(a > b)
    }
    /// `a <= b`, within a hair's breadth.
    pub fn at_most(a: f64, b: f64) -> f64 {
        number(a <= b || !differ(a, b))
    }
    /// `a >= b`, within a hair's breadth.
    pub fn at_least(a: f64, b: f64) -> f64 {
        number(a >= b || !differ(a, b))
    }
    /// `a & b`.
    pub fn and(a: f64, b: f64) -> f64 {
        number(truth(a) && truth(b))
    }
    /// `a | b`.
    pub fn or(a: f64, b: f64) -> f64 {
        number(truth(a) || truth(b))
    }
    /// `!a`.
    pub fn not(a: f64) -> f64 {
        number(!truth(a))
    }
}

/// A number as POV-Ray converts it to a 32-bit integer: cut towards zero, the least integer when
/// it does not fit.
pub fn to_int(value: f64) -> i32 {
    if value > -2147483649.0 && value < 2147483648.0 { value as i32 } else { i32::MIN }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_float_is_repeated_and_a_short_vector_gets_zeros() {
        let sum = Tuple::new(&[1.0, 2.0]).zip(Tuple::new(&[1.0; 5]), |a, b| a + b);
        assert_eq!(sum.components(), [2.0, 3.0, 1.0, 1.0, 1.0]);
        let sum = Tuple::float(1.0).zip(Tuple::new(&[1.0; 5]), |a, b| a + b);
        assert_eq!(sum.components(), [2.0; 5]);
    }

    #[test]
    fn numbers_that_do_not_fit_an_integer_become_the_least_one() {
        assert_eq!([to_int(2.7), to_int(-2.7), to_int(1e12), to_int(f64::NAN)], [2, -2, i32::MIN, i32::MIN]);
        assert_eq!([to_int(-2147483648.9), to_int(2147483647.9)], [i32::MIN, i32::MAX]);
    }
}
