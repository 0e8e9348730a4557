//! Colors as the whole numbers a file holds (docs/spec/camera-image.md 11, 12 and 14).

use super::dither::Ditherer;
use super::steps::Steps;
use super::{Encoding, Format};
use crate::math::Gamma;
use crate::render::film::Image;

/// Least alpha by which a color is divided.
const LEAST_ALPHA: f32 = 1e-6;

/// A picture of whole numbers.
#[derive(Debug)]
pub(super) struct Samples {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// 1 for grey, 2 for grey and alpha, 3 for color, 4 for color and alpha.
    pub channels: usize,
    /// Bits of each number.
    pub bits: u8,
    /// The channels of each pixel, rows from top to bottom.
    pub values: Vec<u16>,
}

impl Samples {
    /// Rounds a picture as its encoding asks.
    pub(super) fn new(image: &Image, working: Option<Gamma>, encoding: &Encoding) -> Self {
        let (alpha, grey) = (encoding.alpha, encoding.grey);
        let bits = match (encoding.format, grey) {
            (Format::Png, true) => 16,
            (Format::Png | Format::Ppm, _) => encoding.bits,
            _ => 8,
        };
        let colors = if grey { 1 } else { 3 };
        let channels = colors + usize::from(alpha);
        // A grey map is a table of heights: no curve bends it.
        let straight = grey && encoding.format == Format::Ppm;
        let curve = Curve { working: working.filter(|_| !straight), file: encoding.file_gamma };
        let mut ditherer = encoding.dither.map(|method| Ditherer::new(method, image.width, channels));
        // The table pays from some thousand pixels on, and only while it is small.
        let many = bits <= 8 && image.pixels.len() > 4096;
        let steps = (many && ditherer.is_none()).then(|| Steps::new(curve, bits));
        if let (Some(steps), Format::Png | Format::Ppm, 3) = (&steps, encoding.format, channels) {
            // The most common picture of all.
            let values = image
                .pixels
                .iter()
                .flat_map(|&[r, g, b, _]| [steps.round(r), steps.round(g), steps.round(b)]);
            return Self {
                width: image.width,
                height: image.height,
                channels,
                bits,
                values: values.collect(),
            };
        }
        let mut values = vec![0; image.pixels.len() * channels];
        let (width, height) = (image.width as usize, image.height as usize);
        for row in 0..height {
            // A bitmap is written from its last row to its first, and errors are spread on the way.
            let row = if encoding.format == Format::Bmp { height - 1 - row } else { row };
            for (column, index) in (row * width..(row + 1) * width).enumerate() {
                let (color, opacity) = stored(image.pixels[index], grey, alpha);
                if let Some(ditherer) = &mut ditherer {
                    ditherer.go_to(column, row);
                }
                let numbers = color[..colors].iter().chain(alpha.then_some(&opacity));
                for (channel, value) in numbers.enumerate() {
                    let colored = channel < colors;
                    let curve = if colored { curve } else { Curve::NONE };
                    values[index * channels + channel] = match (&mut ditherer, &steps) {
                        (None, Some(steps)) if colored => steps.round(*value),
                        (None, _) => round(curve.encode(*value), bits),
                        (Some(ditherer), _) => ditherer.round(*value, channel, bits, curve),
                    };
                }
            }
        }
        Self { width: image.width, height: image.height, channels, bits, values }
    }

    /// The numbers as bytes, for formats of eight bits.
    pub(super) fn bytes(&self) -> Vec<u8> {
        self.values.iter().map(|value| *value as u8).collect()
    }
}

/// What a curve does to the numbers of one channel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Curve {
    pub(super) working: Option<Gamma>,
    pub(super) file: Gamma,
}

impl Curve {
    /// Numbers stay as they are.
    const NONE: Self = Self { working: None, file: Gamma::LINEAR };

    /// A number of the working space as the file holds it, unclipped.
    pub(super) fn encode(self, value: f32) -> f32 {
        self.working.map_or(value, |working| working.convert(value, self.file))
    }

    /// A number of the file in the working space.
    pub(super) fn decode(self, value: f32) -> f32 {
        self.working.map_or(value, |working| self.file.convert(value, working))
    }
}

/// The nearest whole number of so many bits.
pub(super) fn round(encoded: f32, bits: u8) -> u16 {
    (encoded.clamp(0.0, 1.0) * scale(bits) + 0.5).floor() as u16
}

/// The greatest number of so many bits.
pub(super) fn scale(bits: u8) -> f32 {
    ((1_u32 << bits) - 1) as f32
}

/// Brightness.
fn brightness([red, green, blue]: [f32; 3]) -> f32 {
    0.297 * red + 0.589 * green + 0.114 * blue
}

/// The color and alpha to store: as it is without alpha, divided by it with.
///
/// What is brighter than its alpha allows gets more alpha, or its color would be cut off.
fn stored([red, green, blue, alpha]: [f32; 4], grey: bool, with_alpha: bool) -> ([f32; 3], f32) {
    let bright = brightness([red, green, blue]);
    let color = if grey { [bright; 3] } else { [red, green, blue] };
    if !with_alpha {
        return (color, 1.0);
    }
    let alpha = if bright > alpha { bright.min(1.0) } else { alpha };
    let divisor = if alpha == 0.0 { LEAST_ALPHA } else { alpha };
    (color.map(|channel| channel / divisor), alpha)
}
