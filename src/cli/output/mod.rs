//! From the finished picture to the bytes of a file (docs/spec/camera-image.md 11 to 15).
//!
//! `samples` turns colors into whole numbers (gamma, alpha, dithering, rounding); one module for each
//! format puts those into a file. The same picture gives the same bytes: no file holds a date.

mod bmp;
mod dither;
mod exr;
mod format;
mod hdr;
mod jpeg;
mod place;
mod png;
mod ppm;
mod samples;
mod steps;
mod targa;

pub use dither::Dither;
pub use format::Format;
pub use place::{Opened, Place};

use crate::cli::Problem;
use crate::math::Gamma;
use crate::render::film::Image;
use samples::Samples;

/// How a picture is stored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Encoding {
    /// The file format.
    pub format: Format,
    /// Bits per channel where the format leaves a choice, 5 to 16.
    pub bits: u8,
    /// Whether only brightness is stored.
    pub grey: bool,
    /// Whether alpha is stored.
    pub alpha: bool,
    /// How rounding is spread over neighbours, if it is.
    pub dither: Option<Dither>,
    /// Quality of a JPEG, 2 to 100.
    pub quality: u8,
    /// Curve of the numbers in the file.
    pub file_gamma: Gamma,
    /// Curve that files say they have whose scene names no working space.
    pub display_gamma: Gamma,
}

/// Encodes a picture whose colors are in a working space; none for an old scene without one, whose
/// numbers are stored as they are.
///
/// # Errors
/// The format cannot hold a picture of this size.
pub fn encode(image: &Image, working: Option<Gamma>, encoding: &Encoding) -> Result<Vec<u8>, Problem> {
    // What an old scene's author saw on a display was light there.
    let light = working.unwrap_or(encoding.display_gamma);
    match encoding.format {
        Format::Png => png::encode(&Samples::new(image, working, encoding), working, encoding),
        Format::Ppm => Ok(ppm::encode(&Samples::new(image, working, encoding), encoding)),
        Format::Targa => targa::encode(&Samples::new(image, working, encoding), false),
        Format::CompressedTarga => targa::encode(&Samples::new(image, working, encoding), true),
        Format::Bmp => bmp::encode(&Samples::new(image, working, encoding)),
        Format::Jpeg => jpeg::encode(&Samples::new(image, working, encoding), encoding.quality),
        Format::Hdr => Ok(hdr::encode(image, light)),
        Format::Exr => exr::encode(image, light, encoding.alpha),
    }
}

/// A picture its format has no room for.
fn unfit(format: Format, error: impl std::fmt::Display) -> Problem {
    Problem::new(format!("cannot store the picture as {}: {error}", format.name()))
}

#[cfg(test)]
mod tests;
