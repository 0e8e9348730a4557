//! Patterns: a point becomes a number (docs/spec/patterns-textures.md 2, docs/spec/language.md 6.9).

use std::sync::Arc;

use super::depth::Nested;
use super::image::ImageMap;
use super::{Function, Object, Pigment};
use crate::math::{DVec2, DVec3, Transform};
use crate::source::Span;

/// A pattern with everything that shapes its value: what pigments, normals, densities and textures share.
#[derive(Clone, Debug)]
pub struct Field {
    /// Where the pattern was written.
    pub span: Span,
    /// The formula.
    pub pattern: Nested<Pattern>,
    /// 0 keeps the raw value; see [`Pattern::default_frequency`].
    pub frequency: f32,
    /// Added after the frequency.
    pub phase: f32,
    /// Shape of a period.
    pub wave: Wave,
    /// The classic `turbulence`, which acts last on the point whatever the order of writing.
    pub turbulence: Option<Turbulence>,
    /// Transforms and warps as written; a point goes through them from the last to the first.
    /// Neighbouring transforms are composed (docs/spec/patterns-textures.md 5.1).
    pub warps: Vec<Warp>,
    /// `noise_generator` where written, 1 … 3; otherwise the scene's.
    pub noise_generator: Option<u8>,
}

/// The shape of a pattern's period (docs/spec/patterns-textures.md 2.1).
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum Wave {
    #[default]
    Ramp,
    Triangle,
    Sine,
    Scallop,
    Cubic,
    /// With its exponent.
    Poly(f32),
}

/// `turbulence`, `octaves`, `omega`, `lambda`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turbulence {
    /// Strength along each axis.
    pub amount: DVec3,
    /// 1 … 10.
    pub octaves: u32,
    /// Share of the next octave's strength.
    pub omega: f32,
    /// Frequency step.
    pub lambda: f32,
}

impl Default for Turbulence {
    fn default() -> Self {
        Self { amount: DVec3::ZERO, octaves: 6, omega: 0.5, lambda: 2.0 }
    }
}

/// Something that moves the point before a pattern sees it (docs/spec/patterns-textures.md 5.2).
#[derive(Clone, Debug)]
pub enum Warp {
    /// Acts inversely on the point.
    Transform(Arc<Transform>),
    /// `warp { turbulence … }`.
    Turbulence(Turbulence),
    /// `warp { repeat … }`.
    Repeat {
        /// Exactly one component is not zero: the width along its axis.
        width: DVec3,
        /// Added once per block.
        offset: DVec3,
        /// Axes mirrored in every other block.
        flip: DVec3,
    },
    /// `warp { black_hole … }`.
    BlackHole(Box<BlackHole>),
    /// `warp { spherical … }`.
    Spherical {
        /// Unit vector.
        orientation: DVec3,
        /// Exponent of the distance.
        dist_exp: f64,
    },
    /// `warp { cylindrical … }`.
    Cylindrical {
        /// Unit vector.
        orientation: DVec3,
        /// Exponent of the distance.
        dist_exp: f64,
    },
    /// `warp { toroidal … }`.
    Toroidal {
        /// Unit vector.
        orientation: DVec3,
        /// Exponent of the distance.
        dist_exp: f64,
        /// Radius of the core circle.
        major_radius: f64,
    },
    /// `warp { planar … }`.
    Planar {
        /// Unit vector.
        orientation: DVec3,
        /// Third coordinate of every point.
        distance: f64,
    },
    /// `warp { cubic }`.
    Cubic,
}

/// `warp { black_hole … }`.
#[derive(Clone, Debug, PartialEq)]
pub struct BlackHole {
    /// Middle.
    pub center: DVec3,
    /// Reach.
    pub radius: f64,
    /// Strength.
    pub strength: f64,
    /// Exponent.
    pub falloff: f64,
    /// Pushes instead of pulls.
    pub inverse: bool,
    /// Only 0 does anything.
    pub kind: u32,
    /// Size of the blocks it repeats in.
    pub repeat: Option<DVec3>,
    /// Uncertainty of the centre in each block.
    pub turbulence: DVec3,
}

/// The formula of a pattern.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum Pattern {
    Agate {
        turbulence: f32,
    },
    Aoi,
    /// The map's entries are weights.
    Average,
    Boxed,
    Bozo,
    Brick {
        size: DVec3,
        mortar: f32,
    },
    Bumps,
    Cells,
    Checker,
    Crackle {
        form: DVec3,
        metric: f64,
        offset: f64,
        solid: bool,
    },
    Cubic,
    Cylindrical,
    DensityFile {
        file: Arc<DensityFile>,
        interpolate: u32,
    },
    Dents,
    Facets {
        size: f64,
        coords: f64,
        metric: f64,
    },
    Fractal(Box<Fractal>),
    Function(Arc<Function>),
    /// Unit vector.
    Gradient(DVec3),
    Granite,
    Hexagon,
    Image(Arc<ImageMap>),
    Leopard,
    Marble,
    Object(Arc<Object>),
    Onion,
    Pavement(Pavement),
    Pigment(Arc<Pigment>),
    Planar,
    Quilted {
        control0: f32,
        control1: f32,
    },
    Radial,
    Ripples,
    Slope(Box<Slope>),
    Spherical,
    Spiral1(i32),
    Spiral2(i32),
    Spotted,
    Square,
    /// 1 … 27.
    Tiling(u32),
    Triangular,
    Waves,
    Wood,
    Wrinkles,
}

/// `density_file df3 "…"`, read.
#[derive(Clone, Debug, PartialEq)]
pub struct DensityFile {
    /// Name as written.
    pub name: String,
    /// Voxels along x, y, z.
    pub size: [usize; 3],
    /// Bytes of a voxel: 1, 2 or 4.
    pub width: usize,
    /// The file's own big-endian numbers, x fastest; the largest a voxel can hold stands for 1.
    pub voxels: Vec<u8>,
}

/// `mandel`, `julia`, `magnet`.
#[derive(Clone, Debug, PartialEq)]
pub struct Fractal {
    /// The set.
    pub kind: FractalKind,
    /// The constant of a Julia set; `None` for a Mandelbrot set.
    pub julia: Option<DVec2>,
    /// Iterations.
    pub iterations: u32,
    /// 2 … 33.
    pub exponent: u32,
    /// Type 0 … 6 and factor of the inside.
    pub interior: (u32, f64),
    /// Type 0 … 8 and factor of the outside.
    pub exterior: (u32, f64),
}

/// Which set a [`Fractal`] draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum FractalKind {
    Mandel,
    Magnet1,
    Magnet2,
}

/// `pavement`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the language's own words")]
pub struct Pavement {
    pub sides: u32,
    pub tiles: u32,
    pub pattern: u32,
    pub exterior: u32,
    pub interior: u32,
    pub form: u32,
}

/// `slope`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// A direction whose length is its weight against that of the altitude, or the point looked at.
    pub direction: DVec3,
    /// `direction` is a point.
    pub point_at: bool,
    /// Slopes stretched to 0 … 1; equal ends leave them.
    pub range: [f64; 2],
    /// `altitude`: direction with its weight, and its range.
    pub altitude: Option<(DVec3, [f64; 2])>,
}

impl Field {
    /// A pattern with its defaults.
    pub fn new(span: Span, pattern: Pattern) -> Self {
        Self {
            span,
            frequency: pattern.default_frequency(),
            phase: 0.0,
            wave: pattern.default_wave(),
            turbulence: matches!(pattern, Pattern::Agate { .. }).then(Turbulence::default),
            warps: Vec::new(),
            noise_generator: None,
            pattern: Nested::new(pattern),
        }
    }

    /// Appends a transform, as when it is written after everything so far.
    pub fn apply(&mut self, by: &Transform) {
        match self.warps.last_mut() {
            Some(Warp::Transform(last)) => *last = Arc::new(last.then(by)),
            _ => self.warps.push(Warp::Transform(Arc::new(*by))),
        }
    }
}

impl Pattern {
    /// How many entries the pattern's list of colours, pigments, normals or textures has;
    /// `None` for patterns that take maps.
    pub fn list_length(&self) -> Option<usize> {
        match self {
            Self::Checker | Self::Brick { .. } | Self::Object(_) => Some(2),
            Self::Hexagon => Some(3),
            Self::Square => Some(4),
            Self::Triangular | Self::Cubic => Some(6),
            _ => None,
        }
    }

    /// Whether normals have a formula for this pattern, which knows neither waves nor slope maps
    /// (docs/spec/patterns-textures.md 4.2).
    pub fn bends_itself(&self) -> bool {
        use Pattern::{Bumps, Dents, Facets, Quilted, Ripples, Waves, Wrinkles};
        matches!(self, Bumps | Dents | Facets { .. } | Quilted { .. } | Ripples | Waves | Wrinkles)
    }

    /// The frequency a pattern has where none is written (docs/spec/patterns-textures.md 2.1).
    pub fn default_frequency(&self) -> f32 {
        let keeps_raw_value =
            self.list_length().is_some() || matches!(self, Self::Quilted { .. } | Self::Image(_));
        if keeps_raw_value { 0.0 } else { 1.0 }
    }

    /// The wave a pattern has where none is written (docs/spec/patterns-textures.md 2.1).
    pub fn default_wave(&self) -> Wave {
        match self {
            Self::Marble | Self::Wood | Self::Spiral1(_) | Self::Spiral2(_) => Wave::Triangle,
            _ => Wave::Ramp,
        }
    }
}
