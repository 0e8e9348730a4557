//! Radiance RGBE files: light itself, a shared exponent to a pixel.

use crate::math::Gamma;
use crate::render::film::Image;

/// Rows of these widths are run-length encoded.
const PACKED: std::ops::RangeInclusive<u32> = 8..=32_767;

/// Longest run, and longest stretch of single bytes.
const RUN: usize = 127;
const SINGLES: usize = 128;

/// Runs shorter than this cost more than they save.
const WORTHWHILE: usize = 3;

/// Encodes a picture, whose numbers follow a curve, without alpha.
pub(super) fn encode(image: &Image, curve: Gamma) -> Vec<u8> {
    let mut bytes = format!(
        "#?RADIANCE\nSOFTWARE=povista\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n",
        image.height, image.width
    )
    .into_bytes();
    for row in image.pixels.chunks(image.width as usize) {
        let row: Vec<[u8; 4]> = row.iter().map(|pixel| shared_exponent(light(*pixel, curve))).collect();
        if PACKED.contains(&image.width) {
            bytes.extend([2, 2]);
            bytes.extend((image.width as u16).to_be_bytes());
            for channel in 0..4 {
                pack(&row.iter().map(|pixel| pixel[channel]).collect::<Vec<u8>>(), &mut bytes);
            }
        } else {
            bytes.extend(row.concat());
        }
    }
    bytes
}

/// A pixel's light.
fn light([red, green, blue, _]: [f32; 4], curve: Gamma) -> [f32; 3] {
    [red, green, blue].map(|channel| curve.decode(channel))
}

/// Three mantissas and the exponent they share.
fn shared_exponent(color: [f32; 3]) -> [u8; 4] {
    let brightest = color.into_iter().fold(0.0, f32::max);
    if !(brightest > 1e-32 && brightest.is_finite()) {
        return [0; 4];
    }
    // The exponent for which the brightest mantissa is at least a half and below one.
    let exponent = brightest.log2().floor() as i32 + 1;
    let exponent = if brightest >= 2.0_f32.powi(exponent) { exponent + 1 } else { exponent };
    let scale = 256.0 / 2.0_f32.powi(exponent);
    let [red, green, blue] = color.map(|channel| (channel * scale).clamp(0.0, 255.0) as u8);
    [red, green, blue, (exponent + 128).clamp(0, 255) as u8]
}

/// Writes one channel of a row as runs and single bytes.
fn pack(mut values: &[u8], bytes: &mut Vec<u8>) {
    let run = |values: &[u8]| values.iter().take(RUN).take_while(|value| **value == values[0]).count();
    while !values.is_empty() {
        let equal = run(values);
        let length = if equal >= WORTHWHILE {
            bytes.extend([SINGLES as u8 + equal as u8, values[0]]);
            equal
        } else {
            let singles = (1..values.len().min(SINGLES)).find(|start| run(&values[*start..]) >= WORTHWHILE);
            let singles = singles.unwrap_or(values.len().min(SINGLES));
            bytes.push(singles as u8);
            bytes.extend(&values[..singles]);
            singles
        };
        values = &values[length..];
    }
}
