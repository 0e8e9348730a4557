//! Pictures as 8-bit samples, the way they stand in the files: no gamma is applied, so a difference
//! of one is one step of what a viewer is given.

use std::io::Cursor;

use image::{DynamicImage, ImageFormat, ImageResult, RgbImage};
use serde::{Deserialize, Serialize};

/// Channels differing by at most this count as the same: rounding may fall either way twice.
const NEAR: u8 = 2;

/// An 8-bit RGBA picture; opaque where the file has no alpha.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: u32,
    height: u32,
    alpha: bool,
    pixels: Vec<[u8; 4]>,
}

/// How far two pictures of one size are apart, in steps of 1/255.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Difference {
    /// The greatest difference of any channel.
    pub worst: u8,
    /// Share of pixels with every channel within 2, 0 … 1.
    pub near: f64,
    /// Mean absolute difference over all channels.
    pub mean: f64,
    /// Root of the mean squared difference over all channels.
    pub rmse: f64,
}

impl Difference {
    /// The share of near pixels in percent, rounded down to hundredths, so that 100 is all of them.
    pub fn near_percent(&self) -> f64 {
        (self.near * 1e4).floor() / 1e2
    }
}

impl Picture {
    /// Reads a PNG file; 16-bit samples are reduced to 8.
    pub fn decode(png: &[u8]) -> ImageResult<Self> {
        let image = image::load_from_memory_with_format(png, ImageFormat::Png)?;
        let alpha = image.color().has_alpha();
        let image = image.into_rgba8();
        let pixels = image.pixels().map(|pixel| pixel.0).collect();
        Ok(Picture { width: image.width(), height: image.height(), alpha, pixels })
    }

    /// Width and height in pixels.
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Red, green, blue and alpha of every pixel, by rows from the top.
    pub fn pixels(&self) -> impl Iterator<Item = &[u8; 4]> {
        self.pixels.iter()
    }

    /// Compares two pictures; nothing where their sizes differ. Alpha counts if either has it.
    pub fn difference(&self, other: &Picture) -> Option<Difference> {
        if self.size() != other.size() || self.pixels.is_empty() {
            return None;
        }
        let channels = if self.alpha || other.alpha { 4 } else { 3 };
        let (mut worst, mut near, mut sum, mut squares) = (0, 0_u64, 0_u64, 0_u64);
        for (a, b) in self.pixels.iter().zip(&other.pixels) {
            let distance = pixel_distance(a, b, channels);
            worst = worst.max(distance);
            near += u64::from(distance <= NEAR);
            for channel in 0..channels {
                let apart = u64::from(a[channel].abs_diff(b[channel]));
                sum += apart;
                squares += apart * apart;
            }
        }
        let pixels = self.pixels.len() as f64;
        let samples = pixels * channels as f64;
        Some(Difference {
            worst,
            near: near as f64 / pixels,
            mean: sum as f64 / samples,
            rmse: (squares as f64 / samples).sqrt(),
        })
    }

    /// Where two pictures of one size differ, as a PNG: black within the tolerance, then from blue
    /// over red to white with the logarithm of the greatest channel difference.
    pub fn heat_map(&self, other: &Picture) -> ImageResult<Vec<u8>> {
        let heat = self.pixels.iter().zip(&other.pixels).flat_map(|(a, b)| heat(pixel_distance(a, b, 4)));
        let image = RgbImage::from_raw(self.width, self.height, heat.collect()).unwrap_or_default();
        let mut png = Vec::new();
        DynamicImage::ImageRgb8(image).write_to(&mut Cursor::new(&mut png), ImageFormat::Png)?;
        Ok(png)
    }
}

/// The greatest channel difference of two pixels.
fn pixel_distance(a: &[u8; 4], b: &[u8; 4], channels: usize) -> u8 {
    (0..channels).map(|channel| a[channel].abs_diff(b[channel])).max().unwrap_or(0)
}

/// The colour of a difference.
fn heat(distance: u8) -> [u8; 3] {
    /// Colours from just beyond the tolerance to the greatest difference.
    const RAMP: [[f64; 3]; 5] =
        [[20., 30., 110.], [110., 30., 150.], [215., 45., 70.], [250., 160., 40.], [255., 255., 225.]];
    if distance <= NEAR {
        return [0; 3];
    }
    let (low, high) = (f64::from(NEAR + 1).ln(), 255_f64.ln());
    let place = (f64::from(distance).ln() - low) / (high - low) * (RAMP.len() - 1) as f64;
    let step = (place as usize).min(RAMP.len() - 2);
    let share = place - step as f64;
    std::array::from_fn(|i| (RAMP[step][i] + (RAMP[step + 1][i] - RAMP[step][i]) * share).round() as u8)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A PNG whose pixels come from a function of column and row.
    pub(crate) fn png(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 3]) -> Vec<u8> {
        let image = RgbImage::from_fn(width, height, |x, y| image::Rgb(pixel(x, y)));
        let mut png = Vec::new();
        DynamicImage::ImageRgb8(image).write_to(&mut Cursor::new(&mut png), ImageFormat::Png).unwrap();
        png
    }

    fn picture(pixel: impl Fn(u32, u32) -> [u8; 3]) -> Picture {
        Picture::decode(&png(10, 4, pixel)).unwrap()
    }

    #[test]
    fn samples_are_taken_as_they_stand_in_the_file() {
        let ramp = picture(|x, y| [x as u8 * 20, y as u8, 7]);
        assert_eq!(ramp.size(), (10, 4));
        assert_eq!(ramp.pixels[13], [60, 1, 7, 255]);
        assert!(!ramp.alpha);
    }

    #[test]
    fn a_picture_is_no_distance_from_itself() {
        let a = picture(|x, y| [x as u8, y as u8, 0]);
        assert_eq!(a.difference(&a).unwrap(), Difference { worst: 0, near: 1.0, mean: 0.0, rmse: 0.0 });
    }

    #[test]
    fn figures_follow_from_single_samples() {
        let a = picture(|_, _| [100; 3]);
        let b = picture(|x, y| match (x, y) {
            (0, 0) => [102, 98, 101], // within the tolerance
            (1, 0) => [100, 103, 100],
            (2, 0) => [90, 100, 100],
            _ => [100; 3],
        });
        let d = a.difference(&b).unwrap();
        assert_eq!(d.worst, 10);
        assert_eq!((d.near, d.near_percent()), (38.0 / 40.0, 95.0));
        assert_eq!(d.mean, (2 + 2 + 1 + 3 + 10) as f64 / 120.0);
        assert_eq!(d.rmse, ((4 + 4 + 1 + 9 + 100) as f64 / 120.0).sqrt());
        assert_eq!(d, b.difference(&a).unwrap());
    }

    #[test]
    fn one_wrong_pixel_is_not_a_hundred_percent() {
        let d = Difference { worst: 3, near: 0.99999, mean: 0.0, rmse: 0.0 };
        assert_eq!(d.near_percent(), 99.99);
    }

    #[test]
    fn pictures_of_different_sizes_are_not_compared() {
        let a = picture(|_, _| [0; 3]);
        let b = Picture::decode(&png(4, 10, |_, _| [0; 3])).unwrap();
        assert_eq!(a.difference(&b), None);
    }

    #[test]
    fn alpha_counts_where_a_picture_has_it() {
        let opaque = Picture { width: 1, height: 1, alpha: false, pixels: vec![[9, 9, 9, 255]] };
        let clear = Picture { alpha: true, pixels: vec![[9, 9, 9, 247]], ..opaque.clone() };
        let d = opaque.difference(&clear).unwrap();
        assert_eq!((d.worst, d.mean), (8, 2.0));
    }

    #[test]
    fn heat_is_black_within_the_tolerance_and_brightens_beyond() {
        assert_eq!(heat(0), [0; 3]);
        assert_eq!(heat(2), [0; 3]);
        let brightness: Vec<u32> =
            [3, 8, 30, 100, 255].iter().map(|&d| heat(d).iter().map(|&c| u32::from(c)).sum()).collect();
        assert!(brightness.is_sorted_by(|a, b| a < b), "{brightness:?}");
        assert_eq!(heat(255), [255, 255, 225]);
    }

    #[test]
    fn the_heat_map_lies_over_the_pictures() {
        let a = picture(|_, _| [0; 3]);
        let b = picture(|x, y| if (x, y) == (7, 2) { [255, 0, 0] } else { [1; 3] });
        let map = Picture::decode(&a.heat_map(&b).unwrap()).unwrap();
        assert_eq!(map.size(), (10, 4));
        let hot: Vec<usize> = (0..40).filter(|&i| map.pixels[i] != [0, 0, 0, 255]).collect();
        assert_eq!(hot, [27]);
    }
}
