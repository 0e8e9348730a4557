//! JPEG files.

use image::ExtendedColorType;
use image::codecs::jpeg::JpegEncoder;

use super::samples::Samples;
use super::{Format, unfit};
use crate::cli::Problem;

/// Encodes a picture with full resolution of color.
///
/// # Errors
/// The picture is wider or higher than the format can say.
pub(super) fn encode(samples: &Samples, quality: u8) -> Result<Vec<u8>, Problem> {
    let mut bytes = Vec::new();
    JpegEncoder::new_with_quality(&mut bytes, quality)
        .encode(&samples.bytes(), samples.width, samples.height, ExtendedColorType::Rgb8)
        .map_err(|error| unfit(Format::Jpeg, error))?;
    Ok(bytes)
}
