//! Reads image files.

use std::error::Error;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::{bmp, exr, gif, hdr, iff, jpeg, png, pnm, shown, tga, tiff};
use crate::compile::Unsupported;
use crate::math::Gamma;
use crate::scene::image::ImageFormat;
use crate::source::Span;

/// Why a file can't be read.
pub(super) type Fault = Box<dyn Error + Send + Sync>;

/// The largest file that is read, and the most memory that its pixels may take: a small file can
/// claim to hold any number of them.
pub(super) const MOST_BYTES: u64 = 1 << 30;

/// A file's pixels as stored; row 0 is the top one.
#[derive(Debug)]
pub(super) struct Decoded {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) raw: Raw,
    pub(super) native: Native,
    /// The format multiplies colours by alpha.
    pub(super) premultiplied: bool,
    /// There is room for transparency, used or not.
    pub(super) has_alpha: bool,
    /// A grey PNG of at most 8 bits: POV-Ray reads these less exactly than others.
    pub(super) coarse_grey: bool,
    /// The number that stands for white, where it isn't the greatest that can be stored.
    pub(super) white: Option<u16>,
}

/// Stored numbers; one to four channels are grey, grey and alpha, RGB, RGBA.
#[derive(Debug)]
pub(super) enum Raw {
    Bytes { channels: usize, data: Vec<u8> },
    Words { channels: usize, data: Vec<u16> },
    Floats(Vec<[f32; 4]>),
    Palette { indices: Vec<u8>, colors: Vec<[f32; 4]> },
}

/// What a file tells about its curve.
#[derive(Clone, Copy, Debug)]
pub(super) enum Native {
    /// Nothing; the format is meant for screens.
    Srgb,
    /// The curve, or linear light.
    Known(Gamma),
    /// The format has no curve.
    Untouched,
}

impl Decoded {
    /// Straight colours; channels tell whether there is alpha.
    pub(super) fn new([width, height]: [usize; 2], raw: Raw, native: Native) -> Self {
        let has_alpha = match raw {
            Raw::Bytes { channels, .. } | Raw::Words { channels, .. } => channels % 2 == 0,
            Raw::Floats(_) | Raw::Palette { .. } => false,
        };
        let (premultiplied, coarse_grey, white) = (false, false, None);
        Decoded { width, height, raw, native, premultiplied, has_alpha, coarse_grey, white }
    }
}

/// Reads and decodes a file.
pub(super) fn read(span: Span, format: ImageFormat, name: &str, path: &Path) -> Result<Decoded, Unsupported> {
    let broken = |error: Fault| Unsupported::broken(span, format!("cannot read {}: {error}", shown(name)));
    let bytes = content(path).map_err(broken)?;
    let decode = match format {
        ImageFormat::Png => png::read,
        ImageFormat::Gif => gif::read,
        ImageFormat::Pot => gif::read_pot,
        ImageFormat::Bmp => bmp::read,
        ImageFormat::Jpeg => jpeg::read,
        ImageFormat::Tga => tga::read,
        ImageFormat::Pgm | ImageFormat::Ppm => pnm::read,
        ImageFormat::Tiff => tiff::read,
        ImageFormat::Exr => exr::read,
        ImageFormat::Hdr => hdr::read,
        ImageFormat::Iff => iff::read,
        ImageFormat::Sys => {
            return Err(broken("`sys` means no format here; name the one it has".into()));
        }
    };
    decode(&bytes).map_err(broken)
}

fn content(path: &Path) -> Result<Vec<u8>, Fault> {
    let file = File::open(path)?;
    let length = file.metadata()?.len();
    if length > MOST_BYTES {
        return Err(too_large(length));
    }
    // All at once: of what grows every copy has pages of its own. One more for finding the end.
    let mut bytes = Vec::with_capacity(length as usize + 1);
    file.take(MOST_BYTES).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The number of pixels, if that many of `bytes` each may be held.
///
/// # Errors
/// No pixels, or too many.
pub(super) fn room([width, height]: [usize; 2], bytes: usize) -> Result<usize, Fault> {
    if width == 0 || height == 0 {
        return Err("it has no pixels".into());
    }
    let all = (width as u64).saturating_mul(height as u64).saturating_mul(bytes as u64);
    if all > MOST_BYTES {
        return Err(format!("{width} by {height} pixels: {}", too_large(all)).into());
    }
    Ok(width * height)
}

fn too_large(bytes: u64) -> Fault {
    format!("it takes {} MiB, and at most {} are read", bytes >> 20, MOST_BYTES >> 20).into()
}

/// Red, green, blue and alpha, 0 … 1, of a colour of 8 bits.
pub(super) fn color_of_bytes(color: [u8; 4]) -> [f32; 4] {
    color.map(|v| f32::from(v) / 255.0)
}
