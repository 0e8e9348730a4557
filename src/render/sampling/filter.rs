//! Reconstruction filters, as the places samples are drawn from.
//!
//! Samples fall as dense as the filter is high and count alike, so each pixel is finished from its own
//! samples (Ernst, Stamminger, Greiner: Filter Importance Sampling, 2006). Where a filter is negative
//! they count against the others.

use std::sync::LazyLock;

use crate::math::DVec2;
use crate::options::Filter;

/// Pieces into which a filter's distribution is cut.
const PIECES: usize = 1024;

/// A filter along one axis, ready to be drawn from.
struct Distribution {
    radius: f64,
    filter: fn(f64) -> f64,
    /// The share of the filter's magnitude below the start of each piece, from 0 to 1.
    below: Vec<f64>,
}

static TRIANGLE: LazyLock<Distribution> = LazyLock::new(|| Distribution::new(1.0, |x| 1.0 - x.abs()));
/// With a deviation of half a pixel.
static GAUSSIAN: LazyLock<Distribution> = LazyLock::new(|| Distribution::new(1.5, |x| (-2.0 * x * x).exp()));
static MITCHELL: LazyLock<Distribution> = LazyLock::new(|| Distribution::new(2.0, mitchell));

impl Distribution {
    fn new(radius: f64, filter: fn(f64) -> f64) -> Self {
        let middle = |piece: usize| ((piece as f64 + 0.5) / PIECES as f64 * 2.0 - 1.0) * radius;
        let mut below = vec![0.0];
        let mut sum = 0.0;
        for piece in 0..PIECES {
            sum += filter(middle(piece)).abs();
            below.push(sum);
        }
        below.iter_mut().for_each(|share| *share /= sum);
        Self { radius, filter, below }
    }

    /// The place below which a share `u` of the magnitude lies, and whether the filter is negative there.
    fn place(&self, u: f64) -> (f64, bool) {
        let piece = self.below.partition_point(|&share| share <= u).clamp(1, PIECES) - 1;
        let (low, high) = (self.below[piece], self.below[piece + 1]);
        let within = if high > low { (u - low) / (high - low) } else { 0.5 };
        let x = ((piece as f64 + within) / PIECES as f64 * 2.0 - 1.0) * self.radius;
        (x, (self.filter)(x) < 0.0)
    }
}

/// The filter of Mitchell and Netravali with both parameters ⅓ (Reconstruction Filters in Computer
/// Graphics, 1988), but for a constant factor.
fn mitchell(x: f64) -> f64 {
    let x = x.abs();
    if x < 1.0 {
        7.0 * x * x * x - 12.0 * x * x + 16.0 / 3.0
    } else {
        -7.0 / 3.0 * x * x * x + 12.0 * x * x - 20.0 * x + 32.0 / 3.0
    }
}

/// Where a filter puts the point (u, v) of the unit square, in pixels from a pixel's middle, and the
/// weight there, 1 or −1.
pub(super) fn warp(filter: Filter, point: DVec2) -> (DVec2, f32) {
    let distribution = match filter {
        Filter::Box => return (point - 0.5, 1.0),
        Filter::Triangle => &*TRIANGLE,
        Filter::Gaussian => &*GAUSSIAN,
        Filter::Mitchell => &*MITCHELL,
    };
    let ((x, left), (y, right)) = (distribution.place(point.x), distribution.place(point.y));
    (DVec2::new(x, y), if left == right { 1.0 } else { -1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean weight, mean and mean square of x over a fine grid of points.
    fn moments(filter: Filter) -> [f64; 3] {
        let points = (0..10_000).map(|i| DVec2::new((f64::from(i) + 0.5) / 10_000.0, 0.5));
        let mut sums = [0.0; 3];
        for (place, weight) in points.map(|point| warp(filter, point)) {
            let weight = f64::from(weight);
            [weight, weight * place.x, weight * place.x * place.x]
                .iter()
                .zip(&mut sums)
                .for_each(|(value, sum)| *sum += value / 10_000.0);
        }
        sums
    }

    #[test]
    fn places_have_the_moments_of_their_filters() {
        // ∫x²f/∫f: 1/12, 1/6, σ²(1 − 6φ(3)/erf(3/√2)) with σ = 1/2
        for (filter, variance) in
            [(Filter::Box, 1.0 / 12.0), (Filter::Triangle, 1.0 / 6.0), (Filter::Gaussian, 0.24333)]
        {
            let [weight, mean, square] = moments(filter);
            assert!((weight - 1.0).abs() < 1e-9 && mean.abs() < 1e-9, "{filter:?}");
            assert!((square / weight - variance).abs() < 2e-3, "{filter:?}: {square}");
        }
    }

    #[test]
    fn mitchell_counts_against_itself_where_it_is_negative() {
        let [weight, mean, square] = moments(Filter::Mitchell);
        // The integrals of the filter and of its magnitude, by its antiderivative.
        assert!(weight < 1.0 && weight > 0.8 && mean.abs() < 1e-9, "{weight}");
        assert!((square / weight - 1.0 / 9.0).abs() < 2e-3, "{}", square / weight);
    }
}
