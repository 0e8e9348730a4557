//! `jpeg` images.

use jpeg_decoder::{Decoder, PixelFormat};

use super::file::{Decoded, Fault, Native, Raw, room};

/// Decodes a JPEG. Few numbers differ from those of POV-Ray's library, and by no more than 3.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let mut decoder = Decoder::new(bytes);
    decoder.read_info()?;
    let info = decoder.info().ok_or("it has no picture")?;
    let size = [usize::from(info.width), usize::from(info.height)];
    let channels = match info.pixel_format {
        PixelFormat::L8 => 1,
        PixelFormat::RGB24 => 3,
        other => return Err(format!("pixels of the kind {other:?} are unknown").into()),
    };
    // Progressive ones are kept as coefficients of two bytes first.
    room(size, channels * 3)?;
    Ok(Decoded::new(size, Raw::Bytes { channels, data: decoder.decode()? }, Native::Srgb))
}
