//! `bmp` images: Windows and OS/2 bitmaps.

use std::io::Cursor;

use image::DynamicImage;
use image::codecs::bmp::BmpDecoder;

use super::bytes::{Bytes, unpacked};
use super::file::{Decoded, Fault, Native, Raw, color_of_bytes, room};

/// Size of the header of OS/2.
const OLD_HEADER: u32 = 12;

/// `compression` of rows as they are.
const PLAIN: u32 = 0;

/// Decodes a BMP.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let mut file = Bytes(bytes);
    if file.take(2)? != b"BM" {
        return Err("it is no BMP".into());
    }
    file.take(8)?;
    let start = file.u32_le()? as usize;
    let header = file.u32_le()?;
    let ([width, height], bits, compression, used) = if header == OLD_HEADER {
        let size = [i32::from(file.u16_le()?), i32::from(file.u16_le()?)];
        file.take(2)?;
        (size, usize::from(file.u16_le()?), PLAIN, 0)
    } else {
        let size = [file.u32_le()? as i32, file.u32_le()? as i32];
        file.take(2)?;
        let (bits, compression) = (usize::from(file.u16_le()?), file.u32_le()?);
        file.take(12)?;
        let used = file.u32_le()? as usize;
        file.take((header as usize).saturating_sub(36))?;
        (size, bits, compression, used)
    };
    let top_first = height < 0;
    let size = [usize::try_from(width).unwrap_or(0), height.unsigned_abs() as usize];
    room(size, bits.div_ceil(8).max(1))?;
    let line = (size[0] * bits).div_ceil(32) * 4;
    let mut pixels = Bytes(bytes.get(start..).ok_or("the file ends too early")?);
    let ordered = |data: Vec<u8>, line: usize| {
        if top_first { data } else { data.chunks_exact(line).rev().flatten().copied().collect() }
    };
    let raw = match (bits, compression) {
        (1 | 4 | 8, _) => {
            let indices = match (bits, compression) {
                (_, PLAIN) => unpacked(pixels.take(line * size[1])?, line, bits, size[0]),
                (8, 1) | (4, 2) => runs(&mut pixels, size, bits)?,
                _ => return Err(format!("compression {compression} is unknown").into()),
            };
            let entry = if header == OLD_HEADER { 3 } else { 4 };
            let count = if used == 0 { 1 << bits } else { used.min(1 << bits) };
            let palette = file.take(count * entry)?.chunks_exact(entry);
            let colors = palette.map(|c| color_of_bytes([c[2], c[1], c[0], 255])).collect();
            Raw::Palette { indices: ordered(indices, size[0]), colors }
        }
        (24 | 32, PLAIN) => {
            let channels = bits / 8;
            let rows = ordered(pixels.take(line * size[1])?.to_vec(), line);
            let mut data = Vec::with_capacity(size[0] * size[1] * channels);
            for pixel in
                rows.chunks_exact(line).flat_map(|row| row[..size[0] * channels].chunks_exact(channels))
            {
                data.extend([pixel[2], pixel[1], pixel[0]]);
                data.extend(&pixel[3..]);
            }
            Raw::Bytes { channels, data }
        }
        // POV-Ray knows no others.
        _ => match DynamicImage::from_decoder(BmpDecoder::new(Cursor::new(bytes))?)? {
            image if image.color().has_alpha() => {
                Raw::Bytes { channels: 4, data: image.into_rgba8().into_raw() }
            }
            image => Raw::Bytes { channels: 3, data: image.into_rgb8().into_raw() },
        },
    };
    Ok(Decoded::new(size, raw, Native::Srgb))
}

/// Unpacks run-length encoded indices of 4 or 8 bits, row by row; pixels that are jumped over have the
/// first colour.
fn runs(file: &mut Bytes<'_>, [width, height]: [usize; 2], bits: usize) -> Result<Vec<u8>, Fault> {
    let mut indices = vec![0; width * height];
    let (mut x, mut y) = (0, 0);
    let mut put = |x: &mut usize, y: usize, index: u8| {
        if *x < width && y < height {
            indices[y * width + *x] = index;
        }
        *x += 1;
    };
    let halves = |byte: u8, k: usize| match (bits, k % 2) {
        (8, _) => byte,
        (_, 0) => byte >> 4,
        _ => byte & 15,
    };
    while y < height {
        let [count, value] = file.array()?;
        match (count, value) {
            (0, 0) => (x, y) = (0, y + 1),
            (0, 1) => break,
            (0, 2) => {
                let [right, up] = file.array()?;
                (x, y) = (x + usize::from(right), y + usize::from(up));
            }
            (0, count) => {
                let count = usize::from(count);
                let length = (count * bits).div_ceil(8);
                let run = file.take(length)?;
                for k in 0..count {
                    put(&mut x, y, halves(run[k * bits / 8], k));
                }
                file.take(length % 2)?;
            }
            (count, value) => {
                for k in 0..usize::from(count) {
                    put(&mut x, y, halves(value, k));
                }
            }
        }
    }
    Ok(indices)
}
