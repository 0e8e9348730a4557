//! `jpeg` images.
//!
//! No decoder has all the numbers of POV-Ray's library. Where colors are kept as finely as light,
//! `image` has 99 % of them, the others off by up to 3; where they are coarser, `jpeg_decoder`
//! spreads them as that library does and has 91 %.

use std::io::Cursor;

use image::codecs::jpeg::JpegDecoder;
use image::{ColorType, DynamicImage, ImageDecoder};
use jpeg_decoder::Decoder;

use super::file::{Decoded, Fault, Native, Raw, room};

/// Decodes a JPEG.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let decoder = JpegDecoder::new(Cursor::new(bytes))?;
    let (width, height) = decoder.dimensions();
    let size = [width as usize, height as usize];
    let channels = match decoder.color_type() {
        ColorType::L8 => 1,
        ColorType::Rgb8 => 3,
        other => return Err(format!("pixels of the kind {other:?} are unknown").into()),
    };
    // Progressive ones are kept as coefficients of two bytes first.
    room(size, channels * 3)?;
    let data = match has_coarse_colors(bytes) {
        true => Decoder::new(bytes).decode()?,
        false => DynamicImage::from_decoder(decoder)?.into_bytes(),
    };
    Ok(Decoded::new(size, Raw::Bytes { channels, data }, Native::Srgb))
}

/// Whether colors are kept for several pixels at a time: the frame header says how many samples of each
/// component there are.
fn has_coarse_colors(bytes: &[u8]) -> bool {
    let mut rest = bytes.get(2..).unwrap_or_default();
    while let [0xff, marker, high, low, segment @ ..] = rest {
        let length = usize::from(u16::from_be_bytes([*high, *low])).saturating_sub(2);
        let Some((segment, behind)) = segment.split_at_checked(length) else {
            return false;
        };
        let is_frame = matches!(marker, 0xc0..=0xcf) && !matches!(marker, 0xc4 | 0xc8 | 0xcc);
        if is_frame {
            // Precision, height, width and their number; then number, samples and table of each.
            let mut samples = segment.get(6..).unwrap_or_default().chunks_exact(3).map(|c| c[1]);
            let first = samples.next();
            return samples.any(|other| Some(other) != first);
        }
        rest = behind;
    }
    false
}
