//! OpenEXR files: light itself in half precision.

use std::io::Cursor;

use exr::prelude::{Encoding, Image as Layers, SpecificChannels, Vec2, WritableImage, f16};

use super::{Format, unfit};
use crate::cli::Problem;
use crate::math::Gamma;
use crate::render::film::Image;

/// Encodes a picture, whose numbers follow a curve; with alpha, colors stay multiplied by it.
///
/// # Errors
/// The picture is bigger than the format can say.
pub(super) fn encode(image: &Image, curve: Gamma, alpha: bool) -> Result<Vec<u8>, Problem> {
    let size = (image.width as usize, image.height as usize);
    let light = |channel: f32| f16::from_f32(curve.decode(channel));
    let pixel = |Vec2(x, y): Vec2<usize>| image.pixels[y * size.0 + x];
    let mut bytes = Cursor::new(Vec::new());
    let written = if alpha {
        let channels = SpecificChannels::rgba(|place: Vec2<usize>| {
            let [red, green, blue, alpha] = pixel(place);
            (light(red), light(green), light(blue), f16::from_f32(alpha))
        });
        Layers::from_encoded_channels(size, Encoding::SMALL_LOSSLESS, channels)
            .write()
            .to_buffered(&mut bytes)
    } else {
        let channels = SpecificChannels::rgb(|place: Vec2<usize>| {
            let [red, green, blue, _] = pixel(place);
            (light(red), light(green), light(blue))
        });
        Layers::from_encoded_channels(size, Encoding::SMALL_LOSSLESS, channels)
            .write()
            .to_buffered(&mut bytes)
    };
    written.map_err(|error| unfit(Format::Exr, error))?;
    Ok(bytes.into_inner())
}
