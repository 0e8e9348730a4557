//! What a world can do without.

/// Machinery that something in the world uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needs {
    /// Texture coordinates.
    pub uv: bool,
    /// Surface normals, for patterns.
    pub normals: bool,
    /// How many images are decoded.
    pub images: u64,
    /// Media inside objects.
    pub media: bool,
    /// Random numbers, for finishes with grain.
    pub grain: bool,
}
