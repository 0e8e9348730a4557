//! Portable pixmaps, and grey maps under the same extension.

use super::Encoding;
use super::samples::Samples;

/// Encodes a picture with as many bytes as its bits need; a grey map has always two.
pub(super) fn encode(samples: &Samples, encoding: &Encoding) -> Vec<u8> {
    let magic = if encoding.grey { "P5" } else { "P6" };
    let greatest = (1_u32 << samples.bits) - 1;
    let mut bytes = format!("{magic}\n{} {}\n{greatest}\n", samples.width, samples.height).into_bytes();
    if encoding.grey || samples.bits > 8 {
        bytes.extend(samples.values.iter().flat_map(|value| value.to_be_bytes()));
    } else {
        bytes.extend(samples.bytes());
    }
    bytes
}
