//! The file formats and what each can hold (docs/spec/camera-image.md 12 and 15).

/// A format of picture files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// PNG.
    Png,
    /// Portable pixmap.
    Ppm,
    /// Targa, uncompressed.
    Targa,
    /// Targa, run-length encoded.
    CompressedTarga,
    /// Windows bitmap.
    Bmp,
    /// JPEG.
    Jpeg,
    /// Radiance RGBE.
    Hdr,
    /// OpenEXR.
    Exr,
}

impl Format {
    /// The format of a letter of `Output_File_Type`.
    pub fn of_letter(letter: &str) -> Option<Self> {
        Some(match letter {
            "N" => Self::Png,
            "P" => Self::Ppm,
            "T" => Self::Targa,
            "C" => Self::CompressedTarga,
            "B" => Self::Bmp,
            "J" => Self::Jpeg,
            "H" => Self::Hdr,
            "E" => Self::Exr,
            _ => return None,
        })
    }

    /// The letter of `Output_File_Type` for a file's extension, in any case.
    pub fn letter_of_extension(extension: &str) -> Option<&'static str> {
        Some(match extension.to_ascii_lowercase().as_str() {
            "png" => "N",
            "ppm" | "pgm" => "P",
            "tga" => "T",
            "bmp" => "B",
            "jpg" | "jpeg" => "J",
            "hdr" => "H",
            "exr" => "E",
            _ => return None,
        })
    }

    /// The extension of its files, with the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Png => ".png",
            Self::Ppm => ".ppm",
            Self::Targa | Self::CompressedTarga => ".tga",
            Self::Bmp => ".bmp",
            Self::Jpeg => ".jpg",
            Self::Hdr => ".hdr",
            Self::Exr => ".exr",
        }
    }

    /// What POV-Ray calls it on the console.
    pub fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Ppm => "PPM",
            Self::Targa => "Targa",
            Self::CompressedTarga => "RLE Targa",
            Self::Bmp => "BMP",
            Self::Jpeg => "JPEG",
            Self::Hdr => "HDR",
            Self::Exr => "EXR",
        }
    }

    /// Whether it stores alpha.
    pub fn has_alpha(self) -> bool {
        matches!(self, Self::Png | Self::Targa | Self::CompressedTarga | Self::Bmp | Self::Exr)
    }

    /// Whether it stores a single channel.
    pub fn has_grey(self) -> bool {
        matches!(self, Self::Png | Self::Ppm)
    }

    /// Whether POV-Ray writes it to a stream.
    pub fn streams(self) -> bool {
        !matches!(self, Self::Jpeg | Self::Exr)
    }
}
