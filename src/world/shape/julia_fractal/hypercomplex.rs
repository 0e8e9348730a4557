//! Hypercomplex numbers and functions of them (docs/spec/primitives.md 5.3).

use crate::math::{DVec2, DVec4};

/// The functions that a `julia_fractal` applies to both complex numbers a hypercomplex one is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum Function {
    Exp,
    Ln,
    Sin,
    Asin,
    Sinh,
    Asinh,
    Cos,
    Acos,
    Cosh,
    Acosh,
    Tan,
    Atan,
    Tanh,
    Atanh,
    Reciprocal,
    /// `pwr`: to the power of a complex number.
    Power(DVec2),
}

/// The product.
pub(super) fn product(a: DVec4, b: DVec4) -> DVec4 {
    DVec4::new(
        a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w,
        a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
        a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w,
        a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w,
    )
}

impl Function {
    /// The function's value.
    pub(super) fn apply(self, q: DVec4) -> DVec4 {
        apart(q, |z| self.complex(z))
    }

    /// The function's derivative.
    pub(super) fn slope(self, q: DVec4) -> DVec4 {
        apart(q, |z| self.complex_slope(z))
    }

    fn complex_slope(self, z: DVec2) -> DVec2 {
        let one = DVec2::X;
        let square = |z| times(z, z);
        match self {
            Self::Exp => exp(z),
            Self::Ln => reciprocal(z),
            Self::Sin => Self::Cos.complex(z),
            Self::Cos => -Self::Sin.complex(z),
            Self::Sinh => Self::Cosh.complex(z),
            Self::Cosh => Self::Sinh.complex(z),
            Self::Tan => one + square(self.complex(z)),
            Self::Tanh => one - square(self.complex(z)),
            Self::Asin => reciprocal(root(one - square(z))),
            Self::Acos => times(-DVec2::Y, reciprocal(root(square(z) - one))),
            Self::Asinh => reciprocal(root(square(z) + one)),
            Self::Acosh => reciprocal(root(square(z) - one)),
            Self::Atan => reciprocal(one + square(z)),
            Self::Atanh => reciprocal(one - square(z)),
            Self::Reciprocal => -square(reciprocal(z)),
            Self::Power(power) => times(power, times(self.complex(z), reciprocal(z))),
        }
    }

    /// The function's value for a complex number, on the principal branch.
    fn complex(self, z: DVec2) -> DVec2 {
        const I: DVec2 = DVec2::Y;
        let one = DVec2::X;
        let root_of_square_and = |sign: f64| root(times(z, z) + sign * one);
        match self {
            Self::Exp => exp(z),
            Self::Ln => ln(z),
            Self::Sin => DVec2::new(z.x.sin() * z.y.cosh(), z.x.cos() * z.y.sinh()),
            Self::Cos => DVec2::new(z.x.cos() * z.y.cosh(), -z.x.sin() * z.y.sinh()),
            Self::Sinh => DVec2::new(z.x.sinh() * z.y.cos(), z.x.cosh() * z.y.sin()),
            Self::Cosh => DVec2::new(z.x.cosh() * z.y.cos(), z.x.sinh() * z.y.sin()),
            Self::Tan => {
                let (x, y) = (2.0 * z.x, 2.0 * z.y);
                DVec2::new(x.sin(), y.sinh()) / (x.cos() + y.cosh())
            }
            Self::Tanh => {
                let (x, y) = (2.0 * z.x, 2.0 * z.y);
                DVec2::new(x.sinh(), y.sin()) / (y.cos() + x.cosh())
            }
            Self::Asin => times(-I, ln(times(I, z) + root(one - times(z, z)))),
            Self::Acos => times(-I, ln(z + root_of_square_and(-1.0))),
            Self::Asinh => ln(z + root_of_square_and(1.0)),
            Self::Acosh => ln(z + root_of_square_and(-1.0)),
            Self::Atan => 0.5 * times(I, ln(times(one - times(I, z), reciprocal(one + times(I, z))))),
            Self::Atanh => 0.5 * ln(times(one + z, reciprocal(one - z))),
            Self::Reciprocal => reciprocal(z),
            Self::Power(_) if z == DVec2::ZERO => z,
            Self::Power(power) => exp(times(power, ln(z))),
        }
    }
}

/// Applies a function to the two complex numbers that a hypercomplex one is made of.
fn apart(q: DVec4, function: impl Fn(DVec2) -> DVec2) -> DVec4 {
    let a = function(DVec2::new(q.x - q.w, q.y + q.z));
    let b = function(DVec2::new(q.x + q.w, q.y - q.z));
    0.5 * DVec4::new(a.x + b.x, a.y + b.y, a.y - b.y, b.x - a.x)
}

fn times(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

fn reciprocal(z: DVec2) -> DVec2 {
    DVec2::new(z.x, -z.y) / z.length_squared()
}

fn exp(z: DVec2) -> DVec2 {
    z.x.exp() * DVec2::new(z.y.cos(), z.y.sin())
}

fn ln(z: DVec2) -> DVec2 {
    DVec2::new(z.length().ln(), z.y.atan2(z.x))
}

fn root(z: DVec2) -> DVec2 {
    if z == DVec2::ZERO {
        return z;
    }
    let angle = 0.5 * z.y.atan2(z.x);
    z.length().sqrt() * DVec2::new(angle.cos(), angle.sin())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_functions_undo_the_functions() {
        let q = DVec4::new(0.3, 0.2, -0.15, 0.1);
        for (function, inverse) in [
            (Function::Exp, Function::Ln),
            (Function::Sin, Function::Asin),
            (Function::Sinh, Function::Asinh),
            (Function::Tan, Function::Atan),
            (Function::Tanh, Function::Atanh),
            (Function::Reciprocal, Function::Reciprocal),
            (Function::Power(DVec2::new(2.0, 0.0)), Function::Power(DVec2::new(0.5, 0.0))),
        ] {
            let back = inverse.apply(function.apply(q));
            assert!(back.abs_diff_eq(q, 1e-14), "{function:?}: {back}");
        }
        // These have two answers of opposite sign.
        for (function, inverse) in [(Function::Cos, Function::Acos), (Function::Cosh, Function::Acosh)] {
            let there = function.apply(q);
            assert!(function.apply(inverse.apply(there)).abs_diff_eq(there, 1e-14), "{function:?}");
        }
    }

    #[test]
    fn slopes_are_those_of_differences() {
        use Function::*;
        let q = DVec4::new(0.3, 0.2, -0.15, 0.1);
        let power = Power(DVec2::new(3.0, 0.5));
        for function in [
            Exp, Ln, Sin, Asin, Sinh, Asinh, Cos, Acos, Cosh, Acosh, Tan, Atan, Tanh, Atanh, Reciprocal,
            power,
        ] {
            let step = DVec4::new(1e-6, -2e-6, 3e-6, 1e-6);
            let rise = function.apply(q + step) - function.apply(q - step);
            let told = product(function.slope(q), 2.0 * step);
            assert!(rise.abs_diff_eq(told, 1e-8 * told.length()), "{function:?}: {rise} {told}");
        }
    }

    #[test]
    fn squares_are_products() {
        let q = DVec4::new(0.3, 0.2, -0.15, 0.1);
        let square = Function::Power(DVec2::new(2.0, 0.0)).apply(q);
        assert!(square.abs_diff_eq(product(q, q), 1e-15), "{square}");
    }
}
