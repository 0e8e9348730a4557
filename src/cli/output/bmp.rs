//! Windows bitmaps.

use image::ExtendedColorType;
use image::codecs::bmp::BmpEncoder;

use super::samples::Samples;
use super::{Format, unfit};
use crate::cli::Problem;

/// Encodes a picture, with alpha in 32 bits and without in 24.
///
/// # Errors
/// The picture is bigger than the format can say.
pub(super) fn encode(samples: &Samples) -> Result<Vec<u8>, Problem> {
    let kind = if samples.channels == 4 { ExtendedColorType::Rgba8 } else { ExtendedColorType::Rgb8 };
    let mut bytes = Vec::new();
    BmpEncoder::new(&mut bytes)
        .encode(&samples.bytes(), samples.width, samples.height, kind)
        .map_err(|error| unfit(Format::Bmp, error))?;
    Ok(bytes)
}
