//! The finished picture, before any file format.

use crate::math::pages;

/// Samples of a picture in the scene's working space.
///
/// The working space is what `assumed_gamma` says: light itself when it is 1, plain numbers for an
/// old scene without one. Colors are multiplied by alpha and are not clipped.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Red, green, blue and alpha (1 is opaque) of each pixel, rows from top to bottom.
    pub pixels: Vec<[f32; 4]>,
}

impl Image {
    /// A black and opaque picture, as pixels outside the rendered region stay.
    pub fn new(width: u32, height: u32) -> Self {
        if width as usize * height as usize * size_of::<[f32; 4]>() >= pages::MANY {
            pages::huge();
        }
        let pixels = vec![[0.0, 0.0, 0.0, 1.0]; width as usize * height as usize];
        Self { width, height, pixels }
    }
}
