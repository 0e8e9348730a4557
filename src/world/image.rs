//! Images in memory and how they are laid over space (docs/spec/patterns-textures.md 6).

pub(crate) mod along;
pub mod map;

pub use map::{ImageMap, Interpolation, Projection};

use std::sync::Arc;

use crate::math::Rgbft;

/// A decoded image; row 0 is the top one.
#[derive(Clone, Debug)]
pub struct Image {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// What is stored.
    pub pixels: Pixels,
    /// Colours are stored multiplied by alpha.
    pub premultiplied: bool,
    /// The file has room for transparency, used or not.
    pub has_alpha: bool,
}

/// Stored pixels with the curve that decodes them; alpha has none. One to four channels:
/// grey, grey and alpha, RGB, RGBA.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the fields are what the comment says")]
pub enum Pixels {
    /// 8 bits per channel; the curve has 256 entries.
    Bytes { channels: usize, data: Vec<u8>, curve: Box<[f32]> },
    /// 16 bits per channel; the curve has 65536 entries.
    Words { channels: usize, data: Arc<Vec<u16>>, curve: Box<[f32]> },
    /// Decoded red, green, blue, alpha.
    Floats(Vec<[f32; 4]>),
    /// Decoded colours.
    Palette { indices: Arc<[u8]>, colors: Box<[Rgbft]> },
}

impl Image {
    /// The colour of a pixel inside the image. Alpha has become transmit.
    pub fn color(&self, x: usize, y: usize) -> Rgbft {
        let at = y * self.width + x;
        match &self.pixels {
            Pixels::Bytes { channels, data, curve } => {
                let pixel = &data[at * channels..][..*channels];
                unpack(pixel, |v| curve[usize::from(v)], |v| f32::from(v) / 255.0)
            }
            Pixels::Words { channels, data, curve } => {
                let pixel = &data[at * channels..][..*channels];
                unpack(pixel, |v| curve[usize::from(v)], |v| f32::from(v) / 65535.0)
            }
            Pixels::Floats(data) => {
                let [r, g, b, alpha] = data[at];
                Rgbft::new([r, g, b, 0.0, 1.0 - alpha])
            }
            Pixels::Palette { indices, colors } => {
                colors.get(usize::from(indices[at])).copied().unwrap_or(Rgbft::BLACK)
            }
        }
    }

    /// The palette index of a pixel inside the image; `None` where there is no palette.
    pub fn index(&self, x: usize, y: usize) -> Option<u8> {
        match &self.pixels {
            Pixels::Palette { indices, .. } => Some(indices[y * self.width + x]),
            _ => None,
        }
    }

    /// Whether every pixel is opaque.
    pub fn is_opaque(&self) -> bool {
        match &self.pixels {
            Pixels::Bytes { channels: 1 | 3, .. } | Pixels::Words { channels: 1 | 3, .. } => true,
            Pixels::Bytes { channels, data, .. } => data.chunks(*channels).all(|p| p.last() == Some(&255)),
            Pixels::Words { channels, data, .. } => {
                data.chunks(*channels).all(|p| p.last() == Some(&u16::MAX))
            }
            Pixels::Floats(data) => data.iter().all(|p| p[3] == 1.0),
            Pixels::Palette { colors, .. } => colors.iter().all(|c| c.filter == 0.0 && c.transmit == 0.0),
        }
    }
}

fn unpack<T: Copy>(pixel: &[T], light: impl Fn(T) -> f32, alpha: impl Fn(T) -> f32) -> Rgbft {
    let (r, g, b, a) = match *pixel {
        [v] => (v, v, v, None),
        [v, a] => (v, v, v, Some(a)),
        [r, g, b] => (r, g, b, None),
        [r, g, b, a, ..] => (r, g, b, Some(a)),
        [] => return Rgbft::BLACK,
    };
    let transmit = a.map_or(0.0, |a| 1.0 - alpha(a));
    Rgbft::new([light(r), light(g), light(b), 0.0, transmit])
}
