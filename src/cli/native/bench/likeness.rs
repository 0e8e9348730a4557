//! How far pictures are apart as they are seen.

use image::{Rgb, RgbImage};

use crate::math::gamma::Gamma;

/// A picture as a screen shows it: red, green and blue in steps of 255, not rounded.
pub(super) struct Shown {
    pub width: u32,
    pub height: u32,
    pub pixels: Vec<[f32; 3]>,
}

impl Shown {
    /// From colours in a scene's working space; `None` shows plain numbers.
    pub(super) fn new(
        size: (u32, u32),
        working: Option<Gamma>,
        colors: impl Iterator<Item = [f32; 3]>,
    ) -> Self {
        let show = |component: f32| {
            let screen = working.map_or(component, |gamma| Gamma::Srgb.encode(gamma.decode(component)));
            screen.clamp(0.0, 1.0) * 255.0
        };
        Self { width: size.0, height: size.1, pixels: colors.map(|color| color.map(show)).collect() }
    }

    fn rounded(&self) -> RgbImage {
        RgbImage::from_fn(self.width, self.height, |x, y| {
            let pixel = self.pixels[(y * self.width + x) as usize];
            Rgb(pixel.map(|component| component.round() as u8))
        })
    }
}

/// Root of the mean squared difference of two pictures of one size.
pub(super) fn rmse(a: &Shown, b: &Shown) -> f64 {
    let differences = a.pixels.iter().flatten().zip(b.pixels.iter().flatten());
    let sum: f64 = differences.map(|(a, b)| f64::from(a - b).powi(2)).sum();
    (sum / (3 * a.pixels.len().max(1)) as f64).sqrt()
}

/// Likeness of the structure of brightness and of the colours, 1 for the same picture; 0 for
/// pictures of different sizes.
pub(super) fn likeness(a: &Shown, b: &Shown) -> f64 {
    image_compare::rgb_hybrid_compare(&a.rounded(), &b.rounded()).map_or(0.0, |likeness| likeness.score)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(value: f32) -> Shown {
        Shown::new((32, 32), None, std::iter::repeat_n([value; 3], 32 * 32))
    }

    #[test]
    fn differences_are_in_steps_of_a_screen() {
        assert!((rmse(&grey(0.5), &grey(0.25)) - 63.75).abs() < 1e-3);
        assert_eq!(likeness(&grey(0.5), &grey(0.5)), 1.0);
        assert!(likeness(&grey(0.5), &grey(0.1)) < 0.99);
    }
}
