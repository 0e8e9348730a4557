//! `hdr` images: Radiance's RGBE pictures.

use super::bytes::Bytes;
use super::file::{Decoded, Fault, Native, Raw, room};
use crate::math::Gamma;

/// Widths whose rows may be stored channel by channel.
const PACKED: std::ops::Range<usize> = 8..0x8000;

/// Decodes an HDR. Exposure and gamma of the header are not heeded, as in POV-Ray.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let mut file = Bytes(bytes);
    if !file.line(b'\n')?.starts_with(b"#?") {
        return Err("it is no HDR".into());
    }
    while !file.line(b'\n')?.is_empty() {}
    let shape = String::from_utf8_lossy(file.line(b'\n')?).into_owned();
    let words: Vec<_> = shape.split_whitespace().collect();
    let [down @ ("-Y" | "+Y"), height, "+X", width] = words[..] else {
        return Err(format!("pixels in the order `{shape}` are unknown").into());
    };
    let [width, height]: [usize; 2] = [width.parse()?, height.parse()?];
    room([width, height], size_of::<[f32; 4]>())?;
    let mut pixels = Vec::new();
    for _ in 0..height {
        let row = row(&mut file, width)?;
        pixels.extend(row.into_iter().map(light));
    }
    if down == "+Y" {
        pixels = pixels.chunks_exact(width).rev().flatten().copied().collect();
    }
    let decoded = Decoded::new([width, height], Raw::Floats(pixels), Native::Known(Gamma::LINEAR));
    Ok(Decoded { has_alpha: true, ..decoded })
}

/// Mantissas count half a step more than stored.
fn light([r, g, b, exponent]: [u8; 4]) -> [f32; 4] {
    if exponent == 0 {
        return [0.0, 0.0, 0.0, 1.0];
    }
    let scale = (f64::from(exponent) - 136.0).exp2();
    let [r, g, b] = [r, g, b].map(|v| ((f64::from(v) + 0.5) * scale) as f32);
    [r, g, b, 1.0]
}

fn row(file: &mut Bytes<'_>, width: usize) -> Result<Vec<[u8; 4]>, Fault> {
    let mut row = vec![[0; 4]; width];
    let packed =
        matches!(file.0, [2, 2, high, low, ..] if usize::from(*high) << 8 | usize::from(*low) == width);
    if !(packed && PACKED.contains(&width)) {
        flat(file, &mut row)?;
        return Ok(row);
    }
    file.take(4)?;
    for channel in 0..4 {
        let mut x = 0;
        while x < width {
            let head = usize::from(file.byte()?);
            let (count, run) = if head > 128 { (head - 128, true) } else { (head, false) };
            let target = row.get_mut(x..x + count).ok_or("a run is longer than its row")?;
            let stored = file.take(if run { 1 } else { count })?;
            if count == 0 {
                return Err("a run is empty".into());
            }
            for (pixel, &value) in target.iter_mut().zip(stored.iter().cycle()) {
                pixel[channel] = value;
            }
            x += count;
        }
    }
    Ok(row)
}

/// Pixel by pixel; the colour (1, 1, 1) repeats the one before as often as its exponent says, and
/// several such in a row are the digits of one number.
fn flat(file: &mut Bytes<'_>, row: &mut [[u8; 4]]) -> Result<(), Fault> {
    let (mut x, mut shift) = (0, 0);
    while x < row.len() {
        let pixel: [u8; 4] = file.array()?;
        if let ([1, 1, 1, count], true) = (pixel, x > 0) {
            let count = usize::from(count).checked_shl(shift).unwrap_or(usize::MAX);
            let before = row[x - 1];
            let end = x.saturating_add(count).min(row.len());
            row[x..end].fill(before);
            x = end;
            shift += 8;
        } else {
            row[x] = pixel;
            x += 1;
            shift = 0;
        }
    }
    Ok(())
}
