//! Comparing two pictures: numbers, and a map of where they differ.

use std::fmt;
use std::path::Path;

use image::{DynamicImage, Rgb, RgbImage, Rgba32FImage};
use serde::Serialize;

use super::Problem;
use super::output::Place;
use crate::source::Permissions;

/// Differences up to this many steps of 255 are not seen.
const INVISIBLE: f32 = 2.0;

/// The difference at which the heat map is as hot as it gets, in steps of 255.
const HOTTEST: f32 = 64.0;

/// Width in pixels of the gap between pictures side by side.
const GAP: u32 = 8;

/// Colors of the heat map, from no difference to the greatest.
const HEAT: [[f32; 3]; 5] =
    [[0.0, 0.0, 0.0], [30.0, 40.0, 160.0], [200.0, 30.0, 90.0], [255.0, 150.0, 20.0], [255.0, 255.0, 220.0]];

/// How far two pictures are apart; differences are in steps of 255, whatever the files' depth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Difference {
    /// Width of both in pixels.
    pub width: u32,
    /// Height of both in pixels.
    pub height: u32,
    /// The greatest difference of any channel.
    pub max: f32,
    /// The mean difference over all channels.
    pub mean: f64,
    /// The root of the mean squared difference.
    pub rmse: f64,
    /// Signal to noise in decibels; none for equal pictures.
    pub psnr: Option<f64>,
    /// Share of pixels no channel of which differs by more than two steps.
    pub within_2: f64,
    /// Share of pixels that are the same.
    pub equal: f64,
}

/// Reads a picture of any format the program knows.
///
/// # Errors
/// There is no such file, or it holds no picture.
pub fn read(path: &Path) -> Result<DynamicImage, Problem> {
    let cannot =
        |error: &dyn fmt::Display| Problem::new(format!("cannot read `{}`: {error}", path.display()));
    let reader = image::ImageReader::open(path)
        .map_err(|error| cannot(&error))?
        .with_guessed_format()
        .map_err(|error| cannot(&error))?;
    reader.decode().map_err(|error| match error {
        image::ImageError::Unsupported(_) => cannot(&"it is no picture of a kind povista knows"),
        error => cannot(&error),
    })
}

/// Writes a picture in the format of its file's extension, or as PNG where there is none.
///
/// # Errors
/// The file cannot be written, or there is no such format.
pub fn write(picture: &RgbImage, path: &Path) -> Result<(), Problem> {
    let format = match path.extension() {
        None => image::ImageFormat::Png,
        Some(extension) => image::ImageFormat::from_extension(extension)
            .filter(|format| format.writing_enabled())
            .ok_or_else(|| {
                Problem::new(format!("povista writes no `.{}` files", extension.to_string_lossy()))
                    .help("name a `.png`")
            })?,
    };
    let mut bytes = std::io::Cursor::new(Vec::new());
    let cannot =
        |error: &dyn fmt::Display| Problem::new(format!("cannot write `{}`: {error}", path.display()));
    picture.write_to(&mut bytes, format).map_err(|error| cannot(&error))?;
    let opened = Place::File(path.to_owned()).open(&Permissions::default())?;
    opened.finish(&bytes.into_inner()).map_err(|error| cannot(&error))
}

/// Compares two pictures of one size, alpha included where either has it.
///
/// # Errors
/// Their sizes differ.
pub fn compare(ours: &DynamicImage, theirs: &DynamicImage) -> Result<Difference, Problem> {
    let (width, height) = (ours.width(), ours.height());
    if (theirs.width(), theirs.height()) != (width, height) {
        return Err(Problem::new(format!(
            "the pictures differ in size: {width} by {height} and {} by {} pixels",
            theirs.width(),
            theirs.height()
        )));
    }
    let channels = if ours.color().has_alpha() || theirs.color().has_alpha() { 4 } else { 3 };
    let (ours, theirs) = (ours.to_rgba32f(), theirs.to_rgba32f());
    let (mut max, mut sum, mut squares) = (0.0_f32, 0.0, 0.0);
    let (mut within, mut equal) = (0_u64, 0_u64);
    for steps in differences(&ours, &theirs) {
        let steps = &steps[..channels];
        let greatest = steps.iter().copied().fold(0.0, f32::max);
        max = max.max(greatest);
        sum += steps.iter().map(|step| f64::from(*step)).sum::<f64>();
        squares += steps.iter().map(|step| f64::from(*step).powi(2)).sum::<f64>();
        within += u64::from(greatest <= INVISIBLE);
        equal += u64::from(greatest == 0.0);
    }
    let pixels = f64::from(width) * f64::from(height);
    let values = (pixels * channels as f64).max(1.0);
    let rmse = (squares / values).sqrt();
    Ok(Difference {
        width,
        height,
        max,
        mean: sum / values,
        rmse,
        psnr: (rmse > 0.0).then(|| 20.0 * (255.0 / rmse).log10()),
        within_2: within as f64 / pixels.max(1.0),
        equal: equal as f64 / pixels.max(1.0),
    })
}

/// A map of the differences: black where there is none, then blue, red, yellow and white.
pub fn heat_map(ours: &DynamicImage, theirs: &DynamicImage) -> RgbImage {
    let (ours, theirs) = (ours.to_rgba32f(), theirs.to_rgba32f());
    let colors: Vec<u8> =
        differences(&ours, &theirs).flat_map(|steps| heat(steps.into_iter().fold(0.0, f32::max))).collect();
    RgbImage::from_raw(ours.width(), ours.height(), colors).unwrap_or_default()
}

/// Pictures of one height in a row.
pub fn side_by_side(pictures: &[RgbImage]) -> RgbImage {
    let width = pictures.iter().map(|picture| picture.width() + GAP).sum::<u32>().saturating_sub(GAP);
    let height = pictures.iter().map(RgbImage::height).max().unwrap_or(0);
    let mut row = RgbImage::from_pixel(width, height, Rgb([128; 3]));
    let mut left = 0;
    for picture in pictures {
        image::imageops::replace(&mut row, picture, i64::from(left), 0);
        left += picture.width() + GAP;
    }
    row
}

/// The difference of each pixel's channels in steps of 255; numbers that are none count as black.
fn differences<'a>(ours: &'a Rgba32FImage, theirs: &'a Rgba32FImage) -> impl Iterator<Item = [f32; 4]> + 'a {
    let finite = |value: f32| if value.is_finite() { value } else { 0.0 };
    ours.pixels().zip(theirs.pixels()).map(move |(a, b)| {
        std::array::from_fn(|channel| {
            let steps = (finite(a.0[channel]) - finite(b.0[channel])).abs() * 255.0;
            // Eight-bit numbers differ by whole steps; single precision must not make them less.
            if (steps - steps.round()).abs() < 1e-3 { steps.round() } else { steps }
        })
    })
}

/// The color of a difference; the scale is a root, so that small ones show.
fn heat(steps: f32) -> [u8; 3] {
    let place = (steps / HOTTEST).clamp(0.0, 1.0).sqrt() * (HEAT.len() - 1) as f32;
    let below = (place as usize).min(HEAT.len() - 2);
    let part = place - below as f32;
    std::array::from_fn(|channel| {
        let (from, to) = (HEAT[below][channel], HEAT[below + 1][channel]);
        (from + (to - from) * part).round() as u8
    })
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "size                 {} x {}", self.width, self.height)?;
        writeln!(f, "greatest difference  {:.0} of 255", self.max)?;
        writeln!(f, "mean difference      {:.4}", self.mean)?;
        writeln!(f, "RMSE                 {:.4}", self.rmse)?;
        match self.psnr {
            Some(psnr) => writeln!(f, "PSNR                 {psnr:.2} dB")?,
            None => writeln!(f, "PSNR                 infinite")?,
        }
        writeln!(f, "within 2 of 255      {:.3} % of pixels", self.within_2 * 100.0)?;
        write!(f, "equal                {:.3} % of pixels", self.equal * 100.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(values: [u8; 4]) -> DynamicImage {
        let pixels: Vec<u8> = values.iter().flat_map(|value| [*value; 3]).collect();
        DynamicImage::ImageRgb8(RgbImage::from_raw(2, 2, pixels).expect("four pixels"))
    }

    #[test]
    fn a_difference_is_counted_in_steps_of_255() {
        let difference = compare(&grey([0, 10, 20, 255]), &grey([0, 12, 24, 255])).expect("one size");
        assert_eq!(difference.max, 4.0);
        assert!((difference.mean - 1.5).abs() < 1e-9);
        assert!((difference.rmse - 5.0_f64.sqrt()).abs() < 1e-9);
        assert_eq!((difference.within_2, difference.equal), (0.75, 0.5));
        assert!((difference.psnr.expect("they differ") - 41.1411).abs() < 1e-3);
    }

    #[test]
    fn a_picture_equals_itself() {
        let difference = compare(&grey([1, 2, 3, 4]), &grey([1, 2, 3, 4])).expect("one size");
        assert_eq!((difference.max, difference.psnr, difference.equal), (0.0, None, 1.0));
    }

    #[test]
    fn sixteen_bits_are_compared_with_eight() {
        let wide = DynamicImage::ImageRgb16(grey([0, 10, 20, 255]).to_rgb16());
        assert_eq!(compare(&wide, &grey([0, 10, 20, 255])).expect("one size").max, 0.0);
    }

    #[test]
    fn pictures_of_different_size_are_not_compared() {
        let small = DynamicImage::new_rgb8(1, 2);
        assert!(compare(&small, &grey([0; 4])).is_err());
    }

    #[test]
    fn the_heat_map_grows_brighter_with_the_difference() {
        let map = heat_map(&grey([0, 0, 0, 0]), &grey([0, 1, 10, 255]));
        let brightness: Vec<u32> =
            map.pixels().map(|pixel| pixel.0.iter().map(|v| u32::from(*v)).sum()).collect();
        assert_eq!(brightness[0], 0);
        assert!(brightness.windows(2).all(|pair| pair[0] < pair[1]), "{brightness:?}");
    }

    #[test]
    fn pictures_stand_side_by_side_with_a_gap() {
        let row = side_by_side(&[grey([0; 4]).to_rgb8(), grey([255; 4]).to_rgb8()]);
        assert_eq!((row.width(), row.height()), (2 + GAP + 2, 2));
    }
}
