//! Options of compilation and rendering (docs/spec/camera-image.md 9, 10, 17).

use std::ops::Range;

/// How a picture is made.
#[derive(Debug, Clone, PartialEq)]
pub struct RenderOptions {
    /// Width of the whole picture in pixels, at least 1.
    pub width: u32,
    /// Height of the whole picture in pixels, at least 1.
    pub height: u32,
    /// The part that is rendered; the rest of the picture stays black and opaque.
    pub region: Region,
    /// Edge in pixels of the squares the region is cut into, from its top-left corner.
    ///
    /// Antialiasing by [`AntialiasMethod::Neighbours`] depends on it.
    pub block_size: u32,
    /// Antialiasing; none means one sample in the middle of each pixel.
    pub antialias: Option<Antialias>,
    /// povista's own ways to sample, instead of POV-Ray's.
    pub sampling: Option<Sampling>,
    /// What shading leaves out to save time: 0 (flat colors) to 9 (everything).
    pub quality: u8,
    /// Whether the picture is stored with alpha, which changes what a background counts for.
    pub output_alpha: bool,
    /// Number of threads; none means as many as the machine offers. Never changes the picture.
    pub threads: Option<usize>,
    /// The structure that finds the objects near a ray. Never changes the picture.
    pub accelerator: Accelerator,
    /// Whether manual bounds that help nothing are dropped.
    pub remove_bounds: bool,
    /// Whether a bounded union is taken apart.
    pub split_unions: bool,
    /// Whether radiosity gathers in an order that does not depend on threads.
    pub high_reproducibility: bool,
    /// Chooses among the pictures that differ in nothing but their random noise.
    pub seed: u64,
}

/// A rectangle of pixels, counted from the top-left corner of the picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Region {
    /// Columns; may be empty.
    pub columns: Range<u32>,
    /// Rows; may be empty.
    pub rows: Range<u32>,
}

/// How many samples a pixel gets, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Antialias {
    /// Where samples are added.
    pub method: AntialiasMethod,
    /// Samples whose colors differ by at least this are refined, 0 to 1.
    pub threshold: f32,
    /// Fineness, 1 to 9.
    pub depth: u32,
    /// Amount by which samples leave their grid, 0 (none) to 1.
    pub jitter: f32,
    /// Exponent of the space in which samples are compared; at most 0 or near 1 compares light.
    pub gamma: f32,
}

/// The ways to antialias (docs/spec/camera-image.md 9.1 and 9.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AntialiasMethod {
    /// Method 1: a pixel that differs from its left or upper neighbour gets a grid of samples.
    Neighbours,
    /// Method 2: a pixel whose corners differ is split into quadrants, again and again.
    Adaptive,
}

/// povista's own ways to sample a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sampling {
    /// The middle of each pixel and its corners, which neighbours share.
    Corners,
    /// One sample for each square of so many pixels: a first look.
    Every(u32),
    /// As many samples for each pixel, spread evenly.
    Even {
        /// At least 1.
        samples: u32,
        /// What a pixel gathers.
        filter: Filter,
    },
    /// Samples where the estimated error is larger than some.
    Adaptive {
        /// Error of a pixel as it is seen, in steps of 255, at which sampling stops.
        error: f32,
        /// Samples of a pixel at most.
        most: u32,
        /// What a pixel gathers.
        filter: Filter,
    },
    /// The middle of each pixel and its corners, and what it takes to find the edges between them.
    Edges {
        /// Error of a pixel as it is seen, in steps of 255, at which sampling stops.
        error: f32,
        /// Samples of a pixel at most, about.
        most: u32,
    },
    /// As many samples for each pixel as a time allows, one at least.
    Budget {
        /// Seconds by the clock.
        seconds: f32,
        /// What a pixel gathers.
        filter: Filter,
    },
}

/// How much a sample counts for the pixels around it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Filter {
    /// Only for the pixel it lies in, as POV-Ray has it.
    #[default]
    Box,
    /// Less and less up to one pixel away.
    Triangle,
    /// A bell with a deviation of half a pixel, cut 1.5 pixels away.
    Gaussian,
    /// Mitchell and Netravali's, 2 pixels wide, which sharpens edges.
    Mitchell,
}

/// The structure that finds the objects near a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Accelerator {
    /// What suits the scene.
    #[default]
    Auto,
    /// Every object in turn.
    Linear,
    /// An octree.
    Octree,
    /// A tree of boxes.
    Bvh,
}

impl RenderOptions {
    /// The defaults for a whole picture of a size.
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            width,
            height,
            region: Region { columns: 0..width, rows: 0..height },
            block_size: 32,
            antialias: None,
            sampling: None,
            quality: 9,
            output_alpha: false,
            threads: None,
            accelerator: Accelerator::Auto,
            remove_bounds: true,
            split_unions: false,
            high_reproducibility: false,
            seed: 0,
        }
    }
}

impl Region {
    /// Number of pixels in the region.
    pub fn area(&self) -> u64 {
        self.columns.len() as u64 * self.rows.len() as u64
    }
}

impl Default for Antialias {
    /// What `+A` alone means.
    fn default() -> Self {
        Self { method: AntialiasMethod::Neighbours, threshold: 0.3, depth: 3, jitter: 1.0, gamma: 2.5 }
    }
}
