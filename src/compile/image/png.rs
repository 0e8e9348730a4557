//! `png` images.

use std::io::Cursor;

use png::{BitDepth, ColorType, Decoder, Transformations};

use super::bytes::unpacked;
use super::file::{Decoded, Fault, Native, Raw, color_of_bytes, room};
use crate::math::Gamma;

/// Decodes a PNG. As in POV-Ray one transparent colour (`tRNS` without a palette) is not heeded.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    let header = decoder.read_header_info()?;
    let [width, height] = [header.width as usize, header.height as usize];
    let (color_type, bits) = (header.color_type, header.bit_depth as usize);
    room([width, height], color_type.samples() * bits.div_ceil(8))?;
    // Each number of a palette or of grey gets a byte; the rest is as it will be.
    decoder.set_transformations(Transformations::IDENTITY);
    let mut reader = decoder.read_info()?;
    let mut data = vec![0; reader.output_buffer_size().ok_or("its size makes no sense")?];
    let frame = reader.next_frame(&mut data)?;
    data.truncate(frame.buffer_size());
    let info = reader.info();
    let native = match (info.srgb, info.gama_chunk) {
        (Some(_), _) => Native::Known(Gamma::Srgb),
        (None, Some(gamma)) if gamma.into_value() > 0.0 => {
            Native::Known(Gamma::Power(gamma.into_value().recip()))
        }
        _ => Native::Srgb,
    };
    if color_type == ColorType::Indexed {
        let alpha = info.trns.as_deref().unwrap_or(&[]);
        let colors = info.palette.as_deref().unwrap_or(&[]).chunks_exact(3).enumerate();
        let colors = colors
            .map(|(i, c)| color_of_bytes([c[0], c[1], c[2], alpha.get(i).copied().unwrap_or(255)]))
            .collect();
        let raw = Raw::Palette { indices: unpacked(&data, frame.line_size, bits, width), colors };
        return Ok(Decoded { has_alpha: true, ..Decoded::new([width, height], raw, native) });
    }
    let channels = color_type.samples();
    let raw = if frame.bit_depth == BitDepth::Sixteen {
        let data = data.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect();
        Raw::Words { channels, data }
    } else if bits < 8 {
        // 1, 3 or 15 to 255.
        let step = 255 / ((1_u16 << bits) - 1) as u8;
        let data = unpacked(&data, frame.line_size, bits, width);
        Raw::Bytes { channels, data: data.into_iter().map(|v| v * step).collect() }
    } else {
        Raw::Bytes { channels, data }
    };
    let coarse_grey = matches!(raw, Raw::Bytes { channels: 1, .. });
    Ok(Decoded { coarse_grey, ..Decoded::new([width, height], raw, native) })
}
