//! `jpeg` images.

use std::io::Cursor;

use image::codecs::jpeg::JpegDecoder;
use image::{DynamicImage, ImageDecoder};

use super::file::{Decoded, Fault, Native, Raw, room};

/// Decodes a JPEG. The numbers differ by up to a few from those of POV-Ray's library.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let decoder = JpegDecoder::new(Cursor::new(bytes))?;
    let size = decoder.dimensions();
    let size = [size.0 as usize, size.1 as usize];
    room(size, 3)?;
    let raw = match DynamicImage::from_decoder(decoder)? {
        DynamicImage::ImageLuma8(image) => Raw::Bytes { channels: 1, data: image.into_raw() },
        image => Raw::Bytes { channels: 3, data: image.into_rgb8().into_raw() },
    };
    Ok(Decoded::new(size, raw, Native::Srgb))
}
