//! Inverse hyperbolic functions as C libraries calculate them: Rust's own differ in the last digits, and scenes
//! print them.

/// The inverse of the hyperbolic sine.
pub fn asinh(x: f64) -> f64 {
    let a = x.abs();
    let value = if a > 1e9 {
        a.ln() + std::f64::consts::LN_2
    } else if a > 2.0 {
        (2.0 * a + 1.0 / ((x * x + 1.0).sqrt() + a)).ln()
    } else {
        let t = x * x;
        (a + t / (1.0 + (1.0 + t).sqrt())).ln_1p()
    };
    value.copysign(x)
}

/// The inverse of the hyperbolic cosine; NaN below 1.
pub fn acosh(x: f64) -> f64 {
    if x < 1.0 {
        f64::NAN
    } else if x > 1e9 {
        x.ln() + std::f64::consts::LN_2
    } else if x > 2.0 {
        (2.0 * x - 1.0 / (x + (x * x - 1.0).sqrt())).ln()
    } else {
        let t = x - 1.0;
        (t + (2.0 * t + t * t).sqrt()).ln_1p()
    }
}

/// The inverse of the hyperbolic tangent; NaN beyond 1.
pub fn atanh(x: f64) -> f64 {
    let a = x.abs();
    if a > 1.0 {
        return x.atanh();
    }
    let t = a + a;
    let value = if a < 0.5 { 0.5 * (t + t * a / (1.0 - a)).ln_1p() } else { 0.5 * (t / (1.0 - a)).ln_1p() };
    value.copysign(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the C library gives.
    #[test]
    fn the_last_digits_are_those_of_c() {
        assert_eq!(asinh(0.3), 0.29567304756342244);
        assert_eq!(asinh(-5.5), -2.4060591252980172);
        assert_eq!(acosh(1.5), 0.9624236501192069);
        assert_eq!(acosh(7.25), 2.669358110903154);
        assert_eq!(atanh(0.25), 0.25541281188299536);
        assert_eq!(atanh(-0.75), -0.9729550745276566);
        assert!(acosh(0.5).is_nan() && atanh(2.0).is_nan() && atanh(1.0).is_infinite());
        assert_eq!((asinh(f64::INFINITY), asinh(-0.0).to_bits()), (f64::INFINITY, (-0.0_f64).to_bits()));
    }
}
