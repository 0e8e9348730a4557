//! `dents`, `granite`, `wrinkles`: sums and powers of noise (docs/spec/patterns-textures.md 2.2).

use std::cell::RefCell;

use crate::math::noise::{noise, noise_at_four, noise_scaled, noise_scaled_at_four};
use crate::math::wide::widest;
use crate::math::{DVec3, Lanes};

/// Noise, cubed. Normals use it too.
pub(crate) fn dents(generator: u8, p: DVec3) -> f64 {
    let n = noise(generator, p);
    n * n * n
}

/// [`dents`] at four points.
#[inline(always)]
pub(super) fn dents_at_four(generator: u8, [x, y, z]: &[Lanes; 3]) -> Lanes {
    let n = noise_at_four(generator, *x, *y, *z);
    n * n * n
}

/// The frequencies of the six octaves of `granite`.
const GRANITE: [f64; 6] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];

/// Six octaves of folded noise.
pub(super) fn granite(generator: u8, p: DVec3) -> f64 {
    let mut sum = 0.0;
    let values = noise_scaled(generator, 4.0 * p, &GRANITE);
    for (octave, scale) in GRANITE.iter().enumerate() {
        sum += folded(generator, values[octave]) / scale;
    }
    sum
}

/// [`granite`] at four points.
#[inline(always)]
pub(super) fn granite_at_four(generator: u8, point: &[Lanes; 3]) -> Lanes {
    let values = noise_scaled_at_four(generator, &point.map(|coordinate| coordinate * 4.0), &GRANITE);
    let mut sum = Lanes::ZERO;
    for (octave, scale) in GRANITE.iter().enumerate() {
        let folded = values[octave].map(
            #[inline(always)]
            |n| folded(generator, n),
        );
        sum = sum + folded / *scale;
    }
    sum
}

#[inline(always)]
fn folded(generator: u8, n: f64) -> f64 {
    if generator <= 1 { (0.5 - n).abs() } else { (1.0 - 2.0 * n).abs().min(0.5) }
}

/// The frequencies of the ten octaves of `wrinkles`.
pub(crate) const WRINKLES: [f64; 10] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0];

/// Ten octaves of noise.
pub(super) fn wrinkles(generator: u8, p: DVec3) -> f64 {
    let mut sum = 0.0;
    let values = noise_scaled(generator, p, &WRINKLES);
    for (octave, scale) in WRINKLES.iter().enumerate() {
        sum += height(generator, values[octave]) / scale;
    }
    sum / 2.0
}

/// Four points and the `wrinkles` there.
struct Known {
    generator: u8,
    point: [Lanes; 3],
    values: Lanes,
}

thread_local! {
    /// The last four points: a map is often chosen from by the very pattern that its entries show.
    static LAST: RefCell<Known> =
        const { RefCell::new(Known { generator: 0, point: [Lanes::splat(f64::NAN); 3], values: Lanes::ZERO }) };
}

/// [`wrinkles`] at four points.
pub(super) fn wrinkles_at_four(generator: u8, point: &[Lanes; 3]) -> Lanes {
    LAST.with_borrow_mut(|last| {
        if last.generator != generator || last.point != *point {
            let values = widest(
                #[inline(always)]
                || all_wrinkles(generator, point),
            );
            *last = Known { generator, point: *point, values };
        }
        last.values
    })
}

#[inline(always)]
fn all_wrinkles(generator: u8, point: &[Lanes; 3]) -> Lanes {
    let values = noise_scaled_at_four(generator, point, &WRINKLES);
    let mut sum = Lanes::ZERO;
    for (octave, scale) in WRINKLES.iter().enumerate() {
        let height = values[octave].map(
            #[inline(always)]
            |n| height(generator, n),
        );
        sum = sum + height / *scale;
    }
    sum / 2.0
}

#[inline(always)]
fn height(generator: u8, n: f64) -> f64 {
    if generator <= 1 { n } else { (2.0 * n - 0.5).clamp(0.0, 1.0) }
}
