//! Targa files, plain or run-length encoded.

use super::samples::Samples;
use super::{Format, unfit};
use crate::cli::Problem;

/// Longest run or row of single pixels in one packet.
const PACKET: usize = 128;

/// What ends a file of the second version of the format.
const SIGNATURE: &[u8] = b"TRUEVISION-XFILE.\0";

/// Encodes a picture, rows from top to bottom.
///
/// # Errors
/// The picture is wider or higher than the format can say.
pub(super) fn encode(samples: &Samples, compress: bool) -> Result<Vec<u8>, Problem> {
    let edge = |edge: u32| u16::try_from(edge).map_err(|error| unfit(Format::Targa, error));
    let (width, height) = (edge(samples.width)?, edge(samples.height)?);
    let alpha = samples.channels == 4;
    let kind = if compress { 10 } else { 2 };
    let mut bytes = vec![0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    bytes.extend(width.to_le_bytes());
    bytes.extend(height.to_le_bytes());
    bytes.extend(if alpha { [32, 0x28] } else { [24, 0x20] });
    let row = samples.width as usize * samples.channels;
    for row in samples.values.chunks(row) {
        let pixels: Vec<Vec<u8>> = row.chunks(samples.channels).map(pixel).collect();
        if compress {
            pack(&pixels, &mut bytes);
        } else {
            bytes.extend(pixels.concat());
        }
    }
    // Neither an extension area nor a developer's: both offsets are zero.
    bytes.extend([0; 8]);
    bytes.extend(SIGNATURE);
    Ok(bytes)
}

/// A pixel as blue, green, red and perhaps alpha.
fn pixel(channels: &[u16]) -> Vec<u8> {
    let mut bytes: Vec<u8> = channels.iter().map(|value| *value as u8).collect();
    bytes.swap(0, 2);
    bytes
}

/// Writes a row as packets: runs of equal pixels, and pixels one by one.
fn pack(mut pixels: &[Vec<u8>], bytes: &mut Vec<u8>) {
    while let Some(first) = pixels.first() {
        let run = pixels.iter().take(PACKET).take_while(|pixel| *pixel == first).count();
        let length = if run > 1 {
            bytes.push(0x80 | (run - 1) as u8);
            bytes.extend(first);
            run
        } else {
            let singles =
                pixels.windows(2).take(PACKET - 1).take_while(|pair| pair[0] != pair[1]).count().max(1);
            bytes.push((singles - 1) as u8);
            bytes.extend(pixels[..singles].concat());
            singles
        };
        pixels = &pixels[length..];
    }
}
