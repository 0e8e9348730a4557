//! `tga` images: Truevision's TGA, plain or run-length encoded.

use super::bytes::Bytes;
use super::file::{Decoded, Fault, Native, Raw, color_of_bytes, room};

/// Bit of the descriptor: the first row is the top one. The bit for columns is not heeded by POV-Ray.
const TOP_FIRST: u8 = 0x20;

/// Decodes a TGA.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let mut file = Bytes(bytes);
    let [name, has_map, kind] = file.array()?;
    let (first, count, entry_bits) = (file.u16_le()?, file.u16_le()?, usize::from(file.byte()?));
    file.take(4)?;
    let size = [usize::from(file.u16_le()?), usize::from(file.u16_le()?)];
    let [bits, descriptor] = file.array()?;
    file.take(usize::from(name))?;
    let map = file.take(if has_map == 0 { 0 } else { usize::from(count) * entry_bits.div_ceil(8) })?;
    let pixel_bytes = match (kind & !8, bits) {
        (1 | 3, 8) => 1,
        (2, 15 | 16) => 2,
        (2, 24) => 3,
        (2, 32) => 4,
        _ => return Err(format!("a TGA of type {kind} with {bits} bits for a pixel is unknown").into()),
    };
    room(size, pixel_bytes)?;
    let [width, height] = size;
    let line = width * pixel_bytes;
    let mut data = if kind & 8 == 0 {
        file.take(line * height)?.to_vec()
    } else {
        runs(&mut file, pixel_bytes, line * height)?
    };
    if descriptor & TOP_FIRST == 0 {
        data = data.chunks_exact(line).rev().flatten().copied().collect();
    }
    let raw = match kind & !8 {
        1 => {
            let entries = map.chunks_exact(entry_bits.div_ceil(8).max(1));
            let colors = entries.map(|entry| Ok(color_of_bytes(color(entry, entry_bits)?)));
            let colors: Vec<_> = colors.collect::<Result<_, Fault>>()?;
            // Numbers start at the first entry that is stored.
            let first = u8::try_from(first).map_err(|_| "its palette starts too high")?;
            let indices: Vec<u8> = data.into_iter().map(|index| index.wrapping_sub(first)).collect();
            if indices.iter().any(|&index| usize::from(index) >= colors.len()) {
                return Err("a pixel has a colour that is not in the palette".into());
            }
            Raw::Palette { indices, colors }
        }
        3 => Raw::Bytes { channels: 1, data },
        _ => {
            let channels = if matches!(bits, 16 | 32) { 4 } else { 3 };
            let mut channels_of_all = Vec::with_capacity(width * height * channels);
            for pixel in data.chunks_exact(pixel_bytes) {
                channels_of_all.extend_from_slice(&color(pixel, usize::from(bits))?[..channels]);
            }
            Raw::Bytes { channels, data: channels_of_all }
        }
    };
    // Palettes count as having room for transparency.
    let has_alpha = !matches!(raw, Raw::Bytes { channels: 1 | 3, .. });
    Ok(Decoded { has_alpha, ..Decoded::new(size, raw, Native::Srgb) })
}

/// Unpacks runs of pixels until there are `wanted` bytes. A run may go on into the next row.
fn runs(file: &mut Bytes<'_>, pixel_bytes: usize, wanted: usize) -> Result<Vec<u8>, Fault> {
    let mut data = Vec::new();
    while data.len() < wanted {
        let head = file.byte()?;
        let count = usize::from(head & 0x7f) + 1;
        if head & 0x80 == 0 {
            data.extend_from_slice(file.take(count * pixel_bytes)?);
        } else {
            let pixel = file.take(pixel_bytes)?;
            data.extend(pixel.iter().cycle().take(count * pixel_bytes));
        }
    }
    data.truncate(wanted);
    Ok(data)
}

/// Red, green, blue and alpha. Channels of 5 bits are shifted up only, as in POV-Ray, so that the
/// brightest is 248.
fn color(stored: &[u8], bits: usize) -> Result<[u8; 4], Fault> {
    match (bits, stored) {
        (15 | 16, &[low, high]) => {
            let word = u16::from_le_bytes([low, high]);
            let channel = |shift: u16| ((word >> shift & 31) << 3) as u8;
            let alpha = if bits == 15 || high & 0x80 != 0 { 255 } else { 0 };
            Ok([channel(10), channel(5), channel(0), alpha])
        }
        (24, &[b, g, r]) => Ok([r, g, b, 255]),
        (32, &[b, g, r, alpha]) => Ok([r, g, b, alpha]),
        _ => Err(format!("colours of {bits} bits are unknown").into()),
    }
}
