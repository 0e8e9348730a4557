//! The samples of a `height_field` (docs/spec/primitives.md 5.4).

use std::sync::Arc;

use super::Compiled;
use crate::compile::Unsupported;
use crate::compile::image::Use;
use crate::compile::texture::TextureCompiler;
use crate::scene::shape as scene;
use crate::world::image::{Image, Pixels};
use crate::world::shape::height_field::HeightField;

/// The greatest sample.
const WHITE: f64 = 65535.0;

/// What POV-Ray takes of red, green and blue for their grey.
const GREY: [f64; 3] = [0.297, 0.589, 0.114];

/// Compiles a height field.
///
/// # Errors
/// An image that can't be used.
pub fn height_field(
    field: &scene::HeightField,
    images: &mut TextureCompiler,
) -> Result<Compiled, Unsupported> {
    let image = images.image(&field.image, Use::Number)?;
    let heights = plain_words(&image).unwrap_or_else(|| {
        let pixels = 0..image.width * image.height;
        Arc::new(pixels.map(|pixel| sample(&image, pixel)).collect())
    });
    let size = [image.width, image.height];
    Ok(Compiled::rare(HeightField::new(size, heights, field.water_level, field.smooth)))
}

/// The heights themselves, where 16 bits of grey are stored without a curve.
fn plain_words(image: &Image) -> Option<Arc<Vec<u16>>> {
    let Pixels::Words { channels: 1, data, curve } = &image.pixels else {
        return None;
    };
    let as_stored = |(v, light): (usize, &f32)| *light == v as f32 / WHITE as f32;
    curve.iter().enumerate().all(as_stored).then(|| data.clone())
}

/// The height of a pixel. Curves count only where the scene names one or white is not the brightest
/// number that can be stored.
fn sample(image: &Image, at: usize) -> u16 {
    match &image.pixels {
        Pixels::Palette { indices, .. } => u16::from(indices[at]) * 256,
        Pixels::Bytes { channels, data, curve } => {
            let pixel = &data[at * channels..][..*channels];
            let light = |v: u8| curve[usize::from(v)];
            let as_stored = |v: u8| light(v) == f32::from(v) / 255.0;
            match *pixel {
                [grey] | [grey, _] if as_stored(grey) => u16::from(grey) * 257,
                [grey] | [grey, _] => level(light(grey).into()),
                [red, green, ..] if as_stored(red) && as_stored(green) => {
                    u16::from(red) * 256 + u16::from(green)
                }
                [red, green, ..] => (light(red) * 65280.0 + light(green) * 255.0) as u16,
                [] => 0,
            }
        }
        Pixels::Words { channels, data, curve } => {
            let light = |v: u16| curve[usize::from(v)];
            match data[at * channels..][..*channels] {
                [grey] | [grey, _] if light(grey) == f32::from(grey) / WHITE as f32 => grey,
                [grey] | [grey, _] => level(light(grey).into()),
                [r, g, b, ..] => level(grey([r, g, b].map(light))),
                [] => 0,
            }
        }
        Pixels::Floats(data) => {
            let [r, g, b, _] = data[at];
            level(if r == g && g == b { r.into() } else { grey([r, g, b]) })
        }
    }
}

fn level(value: f64) -> u16 {
    (value * WHITE) as u16
}

/// In double precision of single precision colours, so that white has 65534.
fn grey(color: [f32; 3]) -> f64 {
    GREY.iter().zip(color).map(|(weight, v)| weight * f64::from(v)).sum()
}
