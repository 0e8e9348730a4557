//! When samples are enough: quantiles of the chi-square distribution.

use std::f64::consts::TAU;

/// For 1 … `most` samples the variance of their mean that is small enough: the fewer samples, the
/// smaller (docs/spec/camera-image.md 8.4, docs/spec/atmosphere-gi.md 2.7).
pub fn thresholds(most: u32, confidence: f64, variance: f64) -> Vec<f64> {
    if most <= 1 {
        return vec![0.0];
    }
    let last = chi_square(f64::from(most - 1), confidence);
    (1..=most).map(|count| variance * chi_square(f64::from(count), confidence) / last).collect()
}

/// The value that a chi-square variable exceeds with probability `confidence`, halved: as POV-Ray
/// finds it, by at most ten of Newton's steps.
fn chi_square(freedom: f64, confidence: f64) -> f64 {
    let shape = freedom / 2.0;
    let spread = 2.0 / (9.0 * freedom);
    let mut x = shape * (1.0 - spread - normal_quantile(confidence) * spread.sqrt()).powi(3);
    for _ in 0..10 {
        if x <= 0.0 {
            return 0.0;
        }
        let density = ((shape - 1.0) * x.ln() - x - ln_gamma(shape)).exp() / excess(shape);
        let step = (observed_gamma(shape, x) - (1.0 - confidence)) / density;
        x -= step;
        if step.abs() < 1e-10 * x.abs() {
            break;
        }
    }
    x.max(0.0)
}

/// The regularised lower incomplete gamma function with the error that POV-Ray's has: the integral
/// from the nearer end, over a gamma function that is too large.
fn observed_gamma(shape: f64, x: f64) -> f64 {
    let lower = lower_gamma(shape, x);
    if x <= 1.0 || x < shape { lower / excess(shape) } else { 1.0 - (1.0 - lower) / excess(shape) }
}

/// The regularised lower incomplete gamma function, by its power series.
fn lower_gamma(shape: f64, x: f64) -> f64 {
    let mut term = 1.0 / shape;
    let mut sum = term;
    let mut n = shape;
    while term > sum * 1e-15 {
        n += 1.0;
        term *= x / n;
        sum += term;
    }
    sum * (shape * x.ln() - x - ln_gamma(shape)).exp()
}

/// How much too large POV-Ray's gamma function is, found by bisection of the variances at which it
/// stops sampling (docs/spec/camera-image.md 8.4).
fn excess(shape: f64) -> f64 {
    if shape < 13.0 && shape.fract() == 0.5 { 1.040_363 } else { 1.0 }
}

/// The logarithm of the gamma function for positive `x`, by Stirling's series.
fn ln_gamma(x: f64) -> f64 {
    if x < 12.0 {
        return ln_gamma(x + 1.0) - x.ln();
    }
    let series = 1.0 / (12.0 * x) - 1.0 / (360.0 * x.powi(3)) + 1.0 / (1260.0 * x.powi(5));
    (x - 0.5) * x.ln() - x + 0.5 * TAU.ln() + series
}

/// The value a standard normal variable stays below with probability `p`, by bisection.
fn normal_quantile(p: f64) -> f64 {
    let below = |z: f64| {
        let half = 0.5 * lower_gamma(0.5, z * z / 2.0);
        if z < 0.0 { 0.5 - half } else { 0.5 + half }
    };
    let (mut low, mut high) = (-9.0, 9.0);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if below(middle) < p { low = middle } else { high = middle }
    }
    (low + high) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chi_square_quantiles_are_those_of_the_tables() {
        // 90 % exceed: 4.865 with 10, 46.459 with 60 degrees of freedom.
        for (freedom, expected) in [(10.0, 4.865_18), (60.0, 46.458_9)] {
            let ours = 2.0 * chi_square(freedom, 0.9);
            assert!((ours - expected).abs() < 1e-4 * expected, "{freedom}: {ours}");
        }
    }

    /// Of so many samples at most, so many are enough when their variance is this: measured with
    /// lenses, by the colours of 76,800 to 1,228,800 pixels.
    #[test]
    fn thresholds_are_those_that_povray_stops_at() {
        let rows = [
            (6, 4, 0.5, 0.745_845),
            (6, 4, 0.9, 0.647_23),
            (9, 7, 0.9, 0.825_08),
            (14, 7, 0.5, 0.518_305),
            (15, 7, 0.3, 0.507_805),
            (15, 7, 0.9, 0.369_602),
            (17, 7, 0.3, 0.447_261),
            (19, 7, 0.3, 0.399_860),
            (19, 7, 0.5, 0.376_412),
            (19, 7, 0.8, 0.302_856),
            (19, 7, 0.9, 0.264_982),
            (19, 13, 0.5, 0.726_265),
            (19, 13, 0.9, 0.655_12),
            (26, 7, 0.5, 0.264_32),
            (28, 7, 0.5, 0.247_82),
            (30, 7, 0.9, 0.145_625),
            (60, 13, 0.5, 0.215_855),
            (60, 19, 0.9, 0.257_825),
            (60, 37, 0.5, 0.6229),
            (60, 37, 0.9, 0.581_25),
        ];
        for (most, count, confidence, observed) in rows {
            let ours = thresholds(most, confidence, 1.0)[count - 1];
            let apart = (ours / observed - 1.0_f64).abs();
            assert!(apart < 1.5e-4, "{count} of {most} at {confidence}: {ours}, observed {observed}");
        }
    }
}
