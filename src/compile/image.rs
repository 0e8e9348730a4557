//! Compiles images: decodes files and evaluates function images, each once
//! (docs/spec/patterns-textures.md 6).

mod bmp;
mod bytes;
mod exr;
mod file;
mod gif;
mod hdr;
mod iff;
mod jpeg;
mod png;
mod pnm;
mod tga;
mod tiff;

use std::borrow::Cow;
use std::sync::Arc;

use rayon::prelude::*;

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::math::{DVec2, Gamma, Lanes, Rgb, Rgbft};
use crate::scene::image::{ImageOrigin, ImageSource, PaletteSetting};
use crate::scene::settings::Settings;
use crate::scene::{self, Function};
use crate::world;
use crate::world::image::{Image, ImageMap, Interpolation, Pixels, Projection};
use file::{Decoded, Native, Raw};

/// The most pixels a function image may have.
const MOST_PIXELS: u64 = 1 << 28;

/// So many rows of a function image are evaluated by one thread at a time.
const BAND: usize = 16;

/// Room on the stack for patterns within patterns.
const STACK: usize = 64 << 20;

/// What an image's numbers mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    /// Light: `image_map`. The file's gamma counts.
    Color,
    /// Anything else. Only a `gamma` that is written counts.
    Number,
}

impl TextureCompiler<'_> {
    /// The pixels of an image.
    ///
    /// # Errors
    /// A file that can't be read or decoded, a format that povista lacks.
    pub fn image(&mut self, source: &Arc<ImageSource>, purpose: Use) -> Result<Arc<Image>, Unsupported> {
        if let Some((_, image)) = self.images[purpose as usize].get(&Arc::as_ptr(source)) {
            return Ok(image.clone());
        }
        let decoded = match &source.origin {
            ImageOrigin::File { format, name, path } => file::read(source.span, *format, name, path)?,
            ImageOrigin::Function { width, height, function } => {
                self.function_image(source, [*width, *height], function)?
            }
        };
        let image = Arc::new(convert(decoded, source, purpose, self.settings));
        self.images[purpose as usize].insert(Arc::as_ptr(source), (source.clone(), image.clone()));
        Ok(image)
    }

    /// An image laid over space; `colored` where it gives colours rather than numbers.
    pub(super) fn image_map(
        &mut self,
        map: &scene::image::ImageMap,
        colored: bool,
    ) -> Result<ImageMap, Unsupported> {
        let purpose = if colored { Use::Color } else { Use::Number };
        let mut image = self.image(&map.source, purpose)?;
        let mut clearness = [0.0; 2];
        if let Pixels::Palette { indices, colors } = &image.pixels {
            if !map.filter.is_empty() || !map.transmit.is_empty() {
                let mut colors = colors.clone();
                set(&mut colors, &map.filter, |color, amount| color.filter = amount);
                set(&mut colors, &map.transmit, |color, amount| color.transmit = amount);
                let pixels = Pixels::Palette { indices: indices.clone(), colors };
                image = Arc::new(Image { pixels, ..*image });
            }
        } else {
            for (clearness, settings) in clearness.iter_mut().zip([&map.filter, &map.transmit]) {
                for setting in settings {
                    if setting.index.is_some() {
                        let message =
                            "`filter` and `transmit` with a palette index need an image with a palette";
                        return Err(Unsupported::broken(map.source.span, message));
                    }
                    *clearness = setting.amount;
                }
            }
        }
        let size = DVec2::new(image.width as f64, image.height as f64);
        Ok(ImageMap {
            projection: match map.map_type {
                1 => Projection::Spherical,
                2 => Projection::Cylindrical,
                5 => Projection::Torus,
                _ => Projection::Planar,
            },
            interpolation: match map.interpolate {
                2 => Interpolation::Bilinear,
                3 => Interpolation::Bicubic,
                4 => Interpolation::NormalizedDistance,
                _ => Interpolation::None,
            },
            once: map.once,
            // Kept in single precision.
            scale: (size * map.repeat).map(|c| f64::from(c as f32)),
            offset: -map.offset * size,
            clearness,
            use_index: map.use_index,
            use_alpha: map.use_alpha,
            image,
        })
    }

    /// A function evaluated on a grid of points of the unit square, kept in 16 bits.
    fn function_image(
        &mut self,
        source: &ImageSource,
        [width, height]: [u32; 2],
        function: &Arc<Function>,
    ) -> Result<Decoded, Unsupported> {
        if width == 0 || height == 0 || u64::from(width) * u64::from(height) > MOST_PIXELS {
            let message = format!("an image of {width} by {height} pixels");
            return Err(Unsupported::broken(source.span, message));
        }
        let size = [width as usize, height as usize];
        let (channels, data) = function_pixels(&*self.function(function)?, size);
        Ok(Decoded::new(size, Raw::Words { channels, data }, Native::Untouched))
    }
}

/// A function's values over the unit square, row by row: how many channels there are, and their numbers.
fn function_pixels(function: &world::Function, [width, height]: [usize; 2]) -> (usize, Vec<u16>) {
    let place = |i: usize, count: usize| i as f64 / (count - 1).max(1) as f64;
    let channels = if function.call_vector(&[0.0; 3], &mut [0.0; 5]) < 5 { 1 } else { 4 };
    let mut data = vec![0; width * height * channels];
    let fill = |row: usize, pixels: &mut [u16]| {
        let y = Lanes::splat(place(row, height));
        for (group, pixels) in pixels.chunks_mut(Lanes::COUNT * channels).enumerate() {
            let x = |lane: usize| place(group * Lanes::COUNT + lane, width);
            let point = [Lanes([x(0), x(1), x(2), x(3)]), y, Lanes::ZERO];
            let ([r, g, b, _, transmit], _) = function.four_vectors(&point);
            if channels == 1 {
                pixels.copy_from_slice(&words(r, |v| v)[..pixels.len()]);
                continue;
            }
            let [r, g, b] = [words(r, |v| v), words(g, |v| v), words(b, |v| v)];
            let alpha = words(transmit, |v| 1.0 - v);
            for (lane, pixel) in pixels.chunks_exact_mut(4).enumerate() {
                pixel.copy_from_slice(&[r[lane], g[lane], b[lane], alpha[lane]]);
            }
        }
    };
    data.par_chunks_mut(BAND * width * channels).enumerate().for_each(|(band, rows)| {
        stacker::grow(STACK, || {
            for (row, pixels) in rows.chunks_mut(width * channels).enumerate() {
                fill(band * BAND + row, pixels);
            }
        });
    });
    (channels, data)
}

/// The 16 bits that POV-Ray keeps of what a function's values are made into: what is not in 0 … 1 wraps around.
#[inline(always)]
fn words(values: Lanes, made: impl Fn(f32) -> f32) -> [u16; Lanes::COUNT] {
    let mut words = [0; Lanes::COUNT];
    for (word, value) in words.iter_mut().zip(&values.0) {
        let scaled = made(*value as f32) * 65535.0;
        *word = if scaled.abs() < 2_147_483_648.0 { scaled as i32 as u16 } else { 0 };
    }
    words
}

fn set(colors: &mut [Rgbft], settings: &[PaletteSetting], change: impl Fn(&mut Rgbft, f32)) {
    for setting in settings {
        for (index, color) in (0..).zip(colors.iter_mut()) {
            if setting.index.is_none_or(|wanted| wanted == index) {
                change(color, setting.amount);
            }
        }
    }
}

/// From the file's numbers to the scene's working space.
fn convert(decoded: Decoded, source: &ImageSource, purpose: Use, settings: &Settings) -> Image {
    let curve = curve(decoded.native, source.gamma, purpose, settings);
    let light = |stored: f32| curve.map_or(stored, |(from, to)| from.convert(stored, to));
    let (width, height) = (decoded.width, decoded.height);
    let table = |most: u16| -> Box<[f32]> {
        let most = f32::from(most);
        // POV-Ray's steps of single precision.
        let scale = decoded.white.map_or(1.0, |white| (most / f32::from(white)).recip());
        (0..=most as u16).map(|stored| light(f32::from(stored) / most / scale)).collect()
    };
    let pixels = match decoded.raw {
        Raw::Bytes { channels, data } if decoded.coarse_grey => {
            // POV-Ray decodes these first, then keeps 8 bits, cut off.
            let coarse: Vec<u8> = table(255).iter().map(|&v| (coarse_grey(v) * 255.0) as u8).collect();
            let data = data.into_iter().map(|stored| coarse[usize::from(stored)]).collect();
            let curve = (0..=255_u8).map(|stored| f32::from(stored) / 255.0).collect();
            Pixels::Bytes { channels, data, curve }
        }
        Raw::Bytes { channels, data } => Pixels::Bytes { channels, data, curve: table(255) },
        Raw::Words { channels, data } => {
            Pixels::Words { channels, data: Arc::new(data), curve: table(65535) }
        }
        Raw::Floats(mut data) => {
            for [r, g, b, _] in &mut data {
                (*r, *g, *b) = (light(*r), light(*g), light(*b));
            }
            Pixels::Floats(data)
        }
        Raw::Palette { indices, colors } => {
            let colors = colors.into_iter().map(|color| {
                let [r, g, b, _] = color.map(light);
                Rgbft { rgb: Rgb::new(r, g, b), filter: 0.0, transmit: 1.0 - color[3] }
            });
            Pixels::Palette { indices: indices.into(), colors: colors.collect() }
        }
    };
    let has_alpha = decoded.has_alpha;
    let premultiplied = has_alpha && source.premultiplied.unwrap_or(decoded.premultiplied);
    Image { width, height, pixels, premultiplied, has_alpha }
}

/// Grey of three equal channels, in POV-Ray's steps of single precision.
fn coarse_grey(v: f32) -> f32 {
    v * 0.297 + v * 0.589 + v * 0.114
}

/// The curve of the stored numbers and the one to give them; `None` leaves them
/// (docs/spec/patterns-textures.md 6.4).
fn curve(
    native: Native,
    written: Option<Gamma>,
    purpose: Use,
    settings: &Settings,
) -> Option<(Gamma, Gamma)> {
    if purpose == Use::Number {
        return written.map(|from| (from, Gamma::LINEAR));
    }
    let old = settings.effective_version() < 370;
    let working = match settings.assumed_gamma {
        None if old => return written.map(|from| (from, Gamma::LINEAR)),
        None => Gamma::LINEAR,
        Some(given) => given,
    };
    let from = match (written, native) {
        (Some(written), _) => written,
        (None, Native::Known(known)) => known,
        (None, Native::Srgb) if !old => Gamma::Srgb,
        (None, Native::Srgb | Native::Untouched) => return None,
    };
    Some((from, working))
}

/// Pixels across and down.
///
/// # Errors
/// A file that can't be read or decoded.
pub fn size(source: &ImageSource) -> Result<[u32; 2], Unsupported> {
    match &source.origin {
        ImageOrigin::File { format, name, path } => {
            let decoded = file::read(source.span, *format, name, path)?;
            // No format has larger numbers.
            Ok([decoded.width, decoded.height].map(|side| u32::try_from(side).unwrap_or(u32::MAX)))
        }
        &ImageOrigin::Function { width, height, .. } => Ok([width, height]),
    }
}

/// How a message names a file.
fn shown(name: &str) -> Cow<'_, str> {
    if name.is_empty() { "the image".into() } else { format!("`{name}`").into() }
}
