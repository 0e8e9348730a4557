//! Image files and how they are laid over space (docs/spec/patterns-textures.md 6).

use std::path::PathBuf;
use std::sync::Arc;

use super::Function;
use crate::math::{DVec2, Gamma};
use crate::source::Span;

/// Where pixels come from. The file is named here and decoded by `compile`, once, if it is needed.
#[derive(Clone, Debug)]
pub struct ImageSource {
    /// Where the file is named.
    pub span: Span,
    /// File or function.
    pub origin: ImageOrigin,
    /// `gamma` after the file name.
    pub gamma: Option<Gamma>,
    /// `premultiplied` after the file name.
    pub premultiplied: Option<bool>,
}

/// What an [`ImageSource`] is read from.
#[derive(Clone, Debug)]
pub enum ImageOrigin {
    /// A file.
    File {
        /// Its format, from the keyword or the extension.
        format: ImageFormat,
        /// Name as written.
        name: String,
        /// Where it was found.
        path: PathBuf,
    },
    /// `function w, h { … }`.
    Function {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// A number or a colour at (x, y) in the unit square.
        function: Arc<Function>,
    },
}

/// Image formats the language names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum ImageFormat {
    Gif,
    Tga,
    Png,
    Pgm,
    Ppm,
    Jpeg,
    Tiff,
    Bmp,
    Exr,
    Hdr,
    Iff,
    Sys,
    Pot,
}

/// The inside of `image_map`, `bump_map`, `image_pattern` and `material_map`.
#[derive(Clone, Debug)]
pub struct ImageMap {
    /// Pixels.
    pub source: Arc<ImageSource>,
    /// `map_type`: 0 planar, 1 spherical, 2 cylindrical, 5 torus.
    pub map_type: u32,
    /// `interpolate`: 0 for none, 2 bilinear, 3 bicubic, 4 normalised distance.
    pub interpolate: u32,
    /// Outside the image there is nothing.
    pub once: bool,
    /// Shrinks the image so that it fits this often.
    pub repeat: DVec2,
    /// Moves the image, in images.
    pub offset: DVec2,
    /// `filter` settings, in order.
    pub filter: Vec<PaletteSetting>,
    /// `transmit` settings, in order.
    pub transmit: Vec<PaletteSetting>,
    /// `use_index`: palette indices serve as values.
    pub use_index: bool,
    /// `use_alpha` of `image_pattern`.
    pub use_alpha: bool,
}

/// `filter i, F`, `filter all F` and the same with `transmit`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PaletteSetting {
    /// One palette entry, or `None` for `all`.
    pub index: Option<u32>,
    /// The value.
    pub amount: f32,
}
