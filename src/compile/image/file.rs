//! Reads image files.

use std::io::Cursor;
use std::path::Path;

use image::codecs::bmp::BmpDecoder;
use image::{DynamicImage, ImageDecoder};

use super::shown;
use crate::compile::Unsupported;
use crate::math::Gamma;
use crate::scene::image::ImageFormat;
use crate::source::Span;

/// A file's pixels as stored; row 0 is the top one.
pub(super) struct Decoded {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) raw: Raw,
    pub(super) native: Native,
    /// The format multiplies colours by alpha.
    pub(super) premultiplied: bool,
    /// A grey PNG of at most 8 bits: POV-Ray reads these less exactly than others.
    pub(super) coarse_grey: bool,
}

/// Stored numbers; one to four channels are grey, grey and alpha, RGB, RGBA.
pub(super) enum Raw {
    Bytes { channels: usize, data: Vec<u8> },
    Words { channels: usize, data: Vec<u16> },
    Floats { data: Vec<[f32; 4]>, alpha: bool },
    Palette { indices: Vec<u8>, colors: Vec<[u8; 4]> },
}

/// What a file tells about its curve.
#[derive(Clone, Copy)]
pub(super) enum Native {
    /// Nothing; the format is meant for screens.
    Srgb,
    /// The curve, or linear light.
    Known(Gamma),
    /// The format has no curve.
    Untouched,
}

/// Reads and decodes a file.
pub(super) fn read(span: Span, format: ImageFormat, name: &str, path: &Path) -> Result<Decoded, Unsupported> {
    let broken = |error: &dyn std::fmt::Display| {
        Unsupported::broken(span, format!("cannot read {}: {error}", shown(name)))
    };
    let lacking = |format: &str| Err(Unsupported::new(span, format!("{format} images, as {}", shown(name))));
    let bytes = std::fs::read(path).map_err(|error| broken(&error))?;
    let plain = |format, native, premultiplied| {
        let image = image::load_from_memory_with_format(&bytes, format).map_err(|error| broken(&error))?;
        Ok(Decoded { native, premultiplied, ..whole(image) })
    };
    let linear = Native::Known(Gamma::LINEAR);
    let decoded = match format {
        ImageFormat::Png => png(&bytes).map_err(|error| broken(&error))?,
        ImageFormat::Gif => gif(&bytes).map_err(|error| broken(&error))?,
        ImageFormat::Bmp => bmp(&bytes).map_err(|error| broken(&error))?,
        ImageFormat::Jpeg => plain(image::ImageFormat::Jpeg, Native::Srgb, false)?,
        ImageFormat::Tga => plain(image::ImageFormat::Tga, Native::Srgb, false)?,
        ImageFormat::Pgm | ImageFormat::Ppm => plain(image::ImageFormat::Pnm, Native::Untouched, false)?,
        ImageFormat::Tiff => plain(image::ImageFormat::Tiff, Native::Untouched, true)?,
        ImageFormat::Exr => plain(image::ImageFormat::OpenExr, linear, true)?,
        ImageFormat::Hdr => raised(plain(image::ImageFormat::Hdr, linear, false)?),
        ImageFormat::Iff => return lacking("IFF"),
        ImageFormat::Pot => return lacking("POT"),
        ImageFormat::Sys => return lacking("system format"),
    };
    if decoded.width == 0 || decoded.height == 0 {
        return Err(broken(&"it has no pixels"));
    }
    Ok(decoded)
}

/// An image without a palette.
fn whole(image: DynamicImage) -> Decoded {
    let (width, height) = (image.width() as usize, image.height() as usize);
    let floats = |data: Vec<f32>, channels: usize| {
        let four = |p: &[f32]| [p[0], p[1], p[2], p.get(3).copied().unwrap_or(1.0)];
        Raw::Floats { data: data.chunks_exact(channels).map(four).collect(), alpha: channels == 4 }
    };
    let raw = match image {
        DynamicImage::ImageLuma8(image) => Raw::Bytes { channels: 1, data: image.into_raw() },
        DynamicImage::ImageLumaA8(image) => Raw::Bytes { channels: 2, data: image.into_raw() },
        DynamicImage::ImageRgb8(image) => Raw::Bytes { channels: 3, data: image.into_raw() },
        DynamicImage::ImageRgba8(image) => Raw::Bytes { channels: 4, data: image.into_raw() },
        DynamicImage::ImageLuma16(image) => Raw::Words { channels: 1, data: image.into_raw() },
        DynamicImage::ImageLumaA16(image) => Raw::Words { channels: 2, data: image.into_raw() },
        DynamicImage::ImageRgb16(image) => Raw::Words { channels: 3, data: image.into_raw() },
        DynamicImage::ImageRgba16(image) => Raw::Words { channels: 4, data: image.into_raw() },
        DynamicImage::ImageRgb32F(image) => floats(image.into_raw(), 3),
        other => floats(other.into_rgba32f().into_raw(), 4),
    };
    Decoded { width, height, raw, native: Native::Untouched, premultiplied: false, coarse_grey: false }
}

/// POV-Ray takes the mantissas of an RGBE pixel half a step higher. The largest channel, whose
/// mantissa has its top bit set, tells the step.
fn raised(mut decoded: Decoded) -> Decoded {
    if let Raw::Floats { data, .. } = &mut decoded.raw {
        for [r, g, b, _] in data {
            let largest = r.max(*g).max(*b);
            if largest > 0.0 {
                let half_step = (largest.log2().floor() - 8.0).exp2();
                for channel in [r, g, b] {
                    *channel += half_step;
                }
            }
        }
    }
    decoded
}

fn png(bytes: &[u8]) -> Result<Decoded, png::DecodingError> {
    use png::{BitDepth, ColorType, Transformations};
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    let info = decoder.read_header_info()?;
    let palette = info.color_type == ColorType::Indexed;
    // Grey and RGB with a transparent colour get an alpha channel; palettes stay.
    decoder.set_transformations(if palette { Transformations::IDENTITY } else { Transformations::EXPAND });
    let mut reader = decoder.read_info()?;
    let mut data = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let frame = reader.next_frame(&mut data)?;
    data.truncate(frame.buffer_size());
    let info = reader.info();
    let (width, height) = (frame.width as usize, frame.height as usize);
    let native = match (info.srgb, info.gama_chunk) {
        (Some(_), _) => Native::Known(Gamma::Srgb),
        (None, Some(gamma)) if gamma.into_value() > 0.0 => {
            Native::Known(Gamma::Power(gamma.into_value().recip()))
        }
        _ => Native::Srgb,
    };
    let channels = frame.color_type.samples();
    let raw = if palette {
        let alpha = info.trns.as_deref().unwrap_or(&[]);
        let colors = info.palette.as_deref().unwrap_or(&[]).chunks_exact(3).enumerate();
        let colors = colors.map(|(i, c)| [c[0], c[1], c[2], alpha.get(i).copied().unwrap_or(255)]).collect();
        let bits = match frame.bit_depth {
            BitDepth::One => 1,
            BitDepth::Two => 2,
            BitDepth::Four => 4,
            BitDepth::Eight | BitDepth::Sixteen => 8,
        };
        Raw::Palette { indices: unpacked(&data, frame.line_size, bits, width), colors }
    } else if frame.bit_depth == BitDepth::Sixteen {
        let data = data.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect();
        Raw::Words { channels, data }
    } else {
        Raw::Bytes { channels, data }
    };
    let coarse_grey = matches!(raw, Raw::Bytes { channels: 1, .. });
    Ok(Decoded { width, height, raw, native, premultiplied: false, coarse_grey })
}

/// One byte per pixel from rows in which each has `bits`.
fn unpacked(rows: &[u8], line: usize, bits: usize, width: usize) -> Vec<u8> {
    let mask = (0xff_u16 >> (8 - bits)) as u8;
    let pixel = move |row: &[u8], x: usize| {
        let bit = x * bits;
        row[bit / 8] >> (8 - bits - bit % 8) & mask
    };
    rows.chunks_exact(line.max(1)).flat_map(|row| (0..width).map(move |x| pixel(row, x))).collect()
}

/// The first picture of a GIF, on the file's canvas.
fn gif(bytes: &[u8]) -> Result<Decoded, gif::DecodingError> {
    let mut decoder = gif::Decoder::new(Cursor::new(bytes))?;
    let (width, height) = (usize::from(decoder.width()), usize::from(decoder.height()));
    let global = decoder.global_palette().map(<[u8]>::to_vec);
    let mut indices = vec![0; width * height];
    let mut colors = Vec::new();
    if let Some(frame) = decoder.read_next_frame()? {
        let palette = frame.palette.clone().or(global).unwrap_or_default();
        let alpha = |i: usize| if frame.transparent.map(usize::from) == Some(i) { 0 } else { 255 };
        colors = palette.chunks_exact(3).enumerate().map(|(i, c)| [c[0], c[1], c[2], alpha(i)]).collect();
        let [left, top, across] = [frame.left, frame.top, frame.width].map(usize::from);
        for (y, row) in frame.buffer.chunks_exact(across.max(1)).enumerate() {
            let shown = across.min(width.saturating_sub(left));
            let start = (top + y) * width + left;
            if let Some(target) = indices.get_mut(start..start + shown) {
                target.copy_from_slice(&row[..shown]);
            }
        }
    }
    let raw = Raw::Palette { indices, colors };
    Ok(Decoded { width, height, raw, native: Native::Srgb, premultiplied: false, coarse_grey: false })
}

fn bmp(bytes: &[u8]) -> image::ImageResult<Decoded> {
    let mut decoder = BmpDecoder::new(Cursor::new(bytes))?;
    let palette = decoder.get_palette().map(<[[u8; 3]]>::to_vec);
    let Some(palette) = palette else {
        let image = DynamicImage::from_decoder(decoder)?;
        return Ok(Decoded { native: Native::Srgb, ..whole(image) });
    };
    decoder.set_indexed_color(true);
    let (width, height) = decoder.dimensions();
    let mut indices = vec![0; usize::try_from(decoder.total_bytes()).unwrap_or(0)];
    decoder.read_image(&mut indices)?;
    let colors = palette.into_iter().map(|[r, g, b]| [r, g, b, 255]).collect();
    Ok(Decoded {
        width: width as usize,
        height: height as usize,
        raw: Raw::Palette { indices, colors },
        native: Native::Srgb,
        premultiplied: false,
        coarse_grey: false,
    })
}
