//! `gif` images, and `pot`: heights in a GIF.

use std::io::Cursor;
use std::num::NonZeroU64;

use gif::{DecodeOptions, MemoryLimit};

use super::file::{Decoded, Fault, MOST_BYTES, Native, Raw, color_of_bytes, room};

/// The first picture of a GIF, on the file's canvas.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let mut options = DecodeOptions::new();
    options.set_memory_limit(NonZeroU64::new(MOST_BYTES).map_or(MemoryLimit::Unlimited, MemoryLimit::Bytes));
    let mut decoder = options.read_info(Cursor::new(bytes))?;
    let [width, height] = [usize::from(decoder.width()), usize::from(decoder.height())];
    room([width, height], 1)?;
    let global = decoder.global_palette().map(<[u8]>::to_vec);
    let mut indices = vec![0; width * height];
    let frame = decoder.read_next_frame()?.ok_or("it has no picture")?;
    let palette = frame.palette.clone().or(global).unwrap_or_default();
    let alpha = |i: usize| if frame.transparent.map(usize::from) == Some(i) { 0 } else { 255 };
    let colors = palette.chunks_exact(3).enumerate();
    let colors = colors.map(|(i, c)| color_of_bytes([c[0], c[1], c[2], alpha(i)])).collect();
    let [left, top, across] = [frame.left, frame.top, frame.width].map(usize::from);
    for (y, row) in frame.buffer.chunks_exact(across.max(1)).enumerate() {
        let shown = across.min(width.saturating_sub(left));
        let start = (top + y) * width + left;
        if let Some(target) = indices.get_mut(start..start + shown) {
            target.copy_from_slice(&row[..shown]);
        }
    }
    let raw = Raw::Palette { indices, colors };
    Ok(Decoded { has_alpha: true, ..Decoded::new([width, height], raw, Native::Srgb) })
}

/// Heights of 16 bits as Fractint stores them: the left half of the GIF has the high bytes, the right
/// half the low ones.
pub(super) fn read_pot(bytes: &[u8]) -> Result<Decoded, Fault> {
    let gif = read(bytes)?;
    let Raw::Palette { indices, .. } = &gif.raw else { return Ok(gif) };
    let width = gif.width / 2;
    if width == 0 || gif.width % 2 != 0 {
        return Err("its width is odd, but each height takes two pixels".into());
    }
    let rows = indices.chunks_exact(gif.width).map(|row| row.split_at(width));
    let data = rows.flat_map(|(high, low)| high.iter().zip(low).map(|(&h, &l)| u16::from_be_bytes([h, l])));
    let raw = Raw::Words { channels: 1, data: data.collect() };
    Ok(Decoded::new([width, gif.height], raw, Native::Untouched))
}
