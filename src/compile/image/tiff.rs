//! `tiff` images. POV-Ray has libtiff make 8 bits of everything but palettes.

use std::io::Cursor;

use tiff::ColorType;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;

use super::bytes::unpacked;
use super::file::{Decoded, Fault, MOST_BYTES, Native, Raw, room};

/// `ExtraSamples` of alpha that colours are not multiplied by.
const UNASSOCIATED: u16 = 2;

/// The tag that says what numbers mean.
const INTERPRETATION: u16 = 262;

/// `INTERPRETATION` of grey, brightest highest, and of entries of a palette.
const GREY: u8 = 1;
const PALETTE: u8 = 3;

/// Decodes the first picture of a TIFF.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    match indices_as_grey(bytes) {
        Some(bytes) => decode(&bytes, true),
        None => decode(bytes, false),
    }
}

fn decode(bytes: &[u8], palette: bool) -> Result<Decoded, Fault> {
    let mut decoder = Decoder::new(Cursor::new(bytes))?;
    let (width, height) = decoder.dimensions()?;
    let size = [width as usize, height as usize];
    let color = decoder.colortype()?;
    let bits = usize::from(color.bit_depth());
    let channels = usize::from(color.num_samples());
    if !matches!(bits, 1 | 2 | 4 | 8 | 16) {
        return Err(format!("numbers of {bits} bits are unknown in a TIFF").into());
    }
    let count = room(size, channels * bits.div_ceil(8))?;
    let mut limits = Limits::default();
    limits.decoding_buffer_size = MOST_BYTES as usize;
    decoder = decoder.with_limits(limits);
    let extra = decoder.find_tag(Tag::ExtraSamples)?.and_then(|value| value.into_u16_vec().ok());
    let unassociated = extra.is_some_and(|kinds| kinds.first() == Some(&UNASSOCIATED));
    let map = if palette { decoder.get_tag_u16_vec(Tag::ColorMap)? } else { Vec::new() };
    let mut data: Vec<u8> = match decoder.read_image()? {
        DecodingResult::U8(data) if bits < 8 => {
            let line = (size[0] * channels * bits).div_ceil(8);
            let numbers = unpacked(&data, line, bits, size[0] * channels);
            let step = if palette { 1 } else { 255 / ((1_u16 << bits) - 1) as u8 };
            numbers.into_iter().map(|v| v * step).collect()
        }
        DecodingResult::U8(data) => data,
        // libtiff rounds colours and cuts grey off.
        DecodingResult::U16(data) if channels < 3 => data.into_iter().map(|v| (v >> 8) as u8).collect(),
        DecodingResult::U16(data) => data.into_iter().map(|v| ((u32::from(v) + 128) / 257) as u8).collect(),
        _ => return Err("numbers of this kind are unknown in a TIFF".into()),
    };
    if data.len() < count * channels {
        return Err("the file ends too early".into());
    }
    if palette {
        let entries = map.len() / 3;
        let level = |i: usize| f32::from(map[i]) / 65535.0;
        let colors = (0..entries).map(|i| [level(i), level(entries + i), level(2 * entries + i), 1.0]);
        let raw = Raw::Palette { indices: data, colors: colors.collect() };
        return Ok(Decoded::new(size, raw, Native::Untouched));
    }
    match color {
        ColorType::RGBA(_) if unassociated => data.chunks_exact_mut(4).for_each(multiply),
        ColorType::Gray(_) | ColorType::GrayA(_) | ColorType::RGB(_) | ColorType::RGBA(_) => {}
        ColorType::Multiband { num_samples: 2, .. } => {}
        _ => return Err(format!("{color:?} is unknown in a TIFF").into()),
    }
    let decoded = Decoded::new(size, Raw::Bytes { channels, data }, Native::Untouched);
    Ok(Decoded { premultiplied: true, has_alpha: true, ..decoded })
}

/// A TIFF with a palette, changed so that its indices pass for grey: `tiff` decodes no palettes.
/// `None` of any other file.
fn indices_as_grey(bytes: &[u8]) -> Option<Vec<u8>> {
    let little = bytes.starts_with(b"II");
    let word = |at: usize| {
        let pair: [u8; 2] = bytes.get(at..at + 2)?.try_into().ok()?;
        Some(if little { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) })
    };
    let halves = if little { [word(6)?, word(4)?] } else { [word(4)?, word(6)?] };
    let directory = usize::from(halves[0]) << 16 | usize::from(halves[1]);
    let entries = (0..usize::from(word(directory)?)).map(|entry| directory + 2 + 12 * entry);
    let value = entries.clone().find(|&entry| word(entry) == Some(INTERPRETATION))? + 8;
    if word(2)? != 42 || word(value)? != u16::from(PALETTE) {
        return None;
    }
    let mut changed = bytes.to_vec();
    *changed.get_mut(if little { value } else { value + 1 })? = GREY;
    Some(changed)
}

/// Multiplies the colour of a pixel by its alpha, rounding as libtiff does.
fn multiply(pixel: &mut [u8]) {
    if let [r, g, b, alpha] = pixel {
        for channel in [r, g, b] {
            *channel = ((u32::from(*channel) * u32::from(*alpha) + 127) / 255) as u8;
        }
    }
}
