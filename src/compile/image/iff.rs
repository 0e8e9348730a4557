//! `iff` images: interleaved bitmaps of the Amiga (ILBM).

use super::bytes::Bytes;
use super::file::{Decoded, Fault, Native, Raw, color_of_bytes, room};

/// Bit of the viewing mode: pixels change one channel of the pixel before.
const HOLD_AND_MODIFY: u32 = 0x800;

/// Bit of the viewing mode: the upper half of the palette has half the brightness of the lower one.
const HALF_BRIGHT: u32 = 0x80;

/// The `BMHD` chunk, as far as it matters.
struct Header {
    size: [usize; 2],
    planes: usize,
    /// The mask is one more plane.
    masked: bool,
    packed: bool,
}

/// Decodes an ILBM.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let mut file = Bytes(bytes);
    let form = file.take(4)?;
    file.take(4)?;
    if form != b"FORM" || file.take(4)? != b"ILBM" {
        return Err("it is no ILBM".into());
    }
    let (mut header, mut palette, mut mode) = (None, Vec::new(), 0);
    loop {
        let name = file.take(4)?;
        let length = file.u32_be()? as usize;
        if name == b"BODY" {
            let header: Header = header.ok_or("its pixels come before its header")?;
            return body(&mut file, &header, &palette, mode);
        }
        let mut chunk = Bytes(file.take(length)?);
        match name {
            b"BMHD" => header = Some(read_header(&mut chunk)?),
            b"CMAP" => palette = chunk.0.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect(),
            b"CAMG" => mode = chunk.u32_be()?,
            _ => {}
        }
        // Chunks have an even length.
        file.take(length % 2)?;
    }
}

fn read_header(chunk: &mut Bytes<'_>) -> Result<Header, Fault> {
    let size = [usize::from(chunk.u16_be()?), usize::from(chunk.u16_be()?)];
    chunk.take(4)?;
    let [planes, masking, compression] = chunk.array()?;
    if compression > 1 {
        return Err(format!("compression {compression} is unknown").into());
    }
    Ok(Header { size, planes: usize::from(planes), masked: masking == 1, packed: compression == 1 })
}

fn body(file: &mut Bytes<'_>, header: &Header, palette: &[[u8; 3]], mode: u32) -> Result<Decoded, Fault> {
    let Header { size, planes, masked, packed } = *header;
    let [width, height] = size;
    if !(1..=8).contains(&planes) && planes != 24 {
        return Err(format!("pixels of {planes} planes are unknown").into());
    }
    room(size, size_of::<u32>())?;
    let line = width.div_ceil(16) * 2;
    let mut pixels = Vec::new();
    for _ in 0..height {
        let mut row = vec![0_u32; width];
        for plane in 0..planes + usize::from(masked) {
            let bits = if packed { unpack(file, line)? } else { file.take(line)?.to_vec() };
            if plane < planes {
                for (x, pixel) in row.iter_mut().enumerate() {
                    *pixel |= u32::from(bits[x / 8] >> (7 - x % 8) & 1) << plane;
                }
            }
        }
        pixels.extend(row);
    }
    let raw = if planes == 24 {
        let data =
            pixels.into_iter().flat_map(|pixel| [pixel as u8, (pixel >> 8) as u8, (pixel >> 16) as u8]);
        Raw::Bytes { channels: 3, data: data.collect() }
    } else if mode & HOLD_AND_MODIFY != 0 && planes >= 6 {
        let rows = pixels.chunks_exact(width);
        Raw::Bytes { channels: 3, data: rows.flat_map(|row| modified(row, planes - 2, palette)).collect() }
    } else {
        let mut colors = palette.to_vec();
        if mode & HALF_BRIGHT != 0 {
            colors.truncate(32);
            colors.extend(colors.clone().into_iter().map(|color| color.map(|v| v / 2)));
        }
        let colors = colors.into_iter().map(|[r, g, b]| color_of_bytes([r, g, b, 255])).collect();
        Raw::Palette { indices: pixels.into_iter().map(|pixel| pixel as u8).collect(), colors }
    };
    Ok(Decoded::new(size, raw, Native::Untouched))
}

/// A row of pixels of which each is a colour of the palette or changes one channel of the pixel before.
fn modified(row: &[u32], bits: usize, palette: &[[u8; 3]]) -> Vec<u8> {
    let mut color = palette.first().copied().unwrap_or_default();
    let mut data = Vec::with_capacity(row.len() * 3);
    for pixel in row {
        let value = pixel & ((1 << bits) - 1);
        // The lower bits of a channel repeat its upper ones.
        let level = (value << (8 - bits) | value >> (2 * bits).saturating_sub(8)) as u8;
        match pixel >> bits {
            0 => color = palette.get(value as usize).copied().unwrap_or_default(),
            1 => color[2] = level,
            2 => color[0] = level,
            _ => color[1] = level,
        }
        data.extend(color);
    }
    data
}

/// One row of a plane, packed by Apple's PackBits.
fn unpack(file: &mut Bytes<'_>, length: usize) -> Result<Vec<u8>, Fault> {
    let mut row = Vec::new();
    while row.len() < length {
        match file.byte()? as i8 {
            -128 => {}
            run @ ..0 => {
                let value = file.byte()?;
                row.resize(row.len() + 1 + usize::from(run.unsigned_abs()), value);
            }
            count => row.extend_from_slice(file.take(count as usize + 1)?),
        }
    }
    row.truncate(length);
    Ok(row)
}
