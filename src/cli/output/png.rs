//! PNG files.

use ::png::{BitDepth, ColorType, Compression, Encoder, ScaledFloat, SrgbRenderingIntent, chunk};

use super::samples::Samples;
use super::{Encoding, Format, unfit};
use crate::cli::Problem;
use crate::math::Gamma;

/// Encodes a picture; the metadata say which curve its numbers follow and how many bits count.
pub(super) fn encode(
    samples: &Samples,
    working: Option<Gamma>,
    encoding: &Encoding,
) -> Result<Vec<u8>, Problem> {
    let wide = samples.bits > 8;
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, samples.width, samples.height);
    encoder.set_color(match samples.channels {
        1 => ColorType::Grayscale,
        2 => ColorType::GrayscaleAlpha,
        3 => ColorType::Rgb,
        _ => ColorType::Rgba,
    });
    encoder.set_depth(if wide { BitDepth::Sixteen } else { BitDepth::Eight });
    // A picture is soon written: this is twenty times as fast as the smallest file, which is a tenth smaller.
    encoder.set_compression(Compression::Fast);
    // Numbers of an old scene are what its author saw on a display.
    match if working.is_some() { encoding.file_gamma } else { encoding.display_gamma } {
        Gamma::Srgb => encoder.set_source_srgb(SrgbRenderingIntent::Perceptual),
        linear if linear.is_linear() => encoder.set_source_gamma(ScaledFloat::new(1.0)),
        Gamma::Power(exponent) => {
            encoder.set_source_gamma(ScaledFloat::from_scaled((100_000.0 / exponent).round() as u32))
        }
    }
    let error = |error| unfit(Format::Png, error);
    encoder.add_text_chunk("Software".to_owned(), "povista".to_owned()).map_err(error)?;
    let mut writer = encoder.write_header().map_err(error)?;
    let significant = [samples.bits; 4];
    writer.write_chunk(chunk::ChunkType(*b"sBIT"), &significant[..samples.channels]).map_err(error)?;
    writer.write_image_data(&data(samples, wide)).map_err(error)?;
    writer.finish().map_err(error)?;
    Ok(bytes)
}

/// The numbers as eight or sixteen bits, big-endian; narrower ones are widened by repeating their bits.
fn data(samples: &Samples, wide: bool) -> Vec<u8> {
    if samples.bits == 8 {
        return samples.bytes();
    }
    let bits = u32::from(samples.bits);
    let room = if wide { 16 } else { 8 };
    let widened = samples.values.iter().map(|value| {
        let value = u32::from(*value);
        (value << (room - bits) | value >> (2 * bits - room)) as u16
    });
    if wide {
        widened.flat_map(u16::to_be_bytes).collect()
    } else {
        widened.map(|value| value as u8).collect()
    }
}
