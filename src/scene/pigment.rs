//! Pigments, densities and the maps that blend them (docs/spec/patterns-textures.md 2.9 and 3).

use std::sync::Arc;

use super::depth::{Depth, Nested};
use super::image::ImageMap;
use super::pattern::FractalKind;
use super::{Field, Pattern};
use crate::math::{Rgb, Rgbft, Transform};

/// `pigment { … }`.
#[derive(Clone, Debug)]
pub struct Pigment {
    /// Where colours come from.
    pub kind: PigmentKind,
    /// `quick_color`, for quality 5 and lower.
    pub quick_color: Option<Arc<Rgbft>>,
}

/// `density { … }`: a pigment whose filter and transmit mean nothing.
pub type Density = Pigment;

/// Where a pigment's colours come from.
#[derive(Clone, Debug)]
pub enum PigmentKind {
    /// One colour everywhere. A pigment without a pattern is black.
    Color(Rgbft),
    /// A pattern looked up in a map of colours.
    Colors {
        /// The pattern.
        field: Arc<Field>,
        /// `None` takes the pattern's own colours, [`Pattern::default_colors`].
        map: Option<Arc<BlendMap<Rgbft>>>,
    },
    /// A pattern looked up in a map or list of pigments; for `average` the positions are weights.
    Pigments {
        /// The pattern.
        field: Arc<Field>,
        /// The pigments.
        map: Arc<BlendMap<Arc<Pigment>>>,
    },
    /// `image_map`.
    Image {
        /// Warps and transforms; its pattern is [`Pattern::Image`] with the same map.
        field: Arc<Field>,
        /// The image.
        map: Arc<ImageMap>,
    },
    /// `uv_mapping`: the pigment is evaluated at `<u,v,0>`.
    UvMapped(Arc<Pigment>),
}

/// A map: positions and entries in the order written, 1 … 256 of them. List patterns have the
/// positions 0, 1, 2 …; for `average` positions are weights.
#[derive(Clone, Debug, PartialEq)]
pub struct BlendMap<T> {
    /// (position, entry).
    pub entries: Nested<Vec<(f32, T)>>,
}

impl<T: Depth> BlendMap<T> {
    /// A map of these entries.
    pub fn new(entries: Vec<(f32, T)>) -> Self {
        Self { entries: Nested::new(entries) }
    }

    /// The list of a list pattern: entries at 0, 1, 2 ….
    pub fn list(entries: impl IntoIterator<Item = T>) -> Self {
        Self::new(entries.into_iter().enumerate().map(|(i, e)| (i as f32, e)).collect())
    }
}

impl Pigment {
    /// One colour everywhere.
    pub fn color(color: Rgbft) -> Self {
        Self { kind: PigmentKind::Color(color), quick_color: None }
    }

    /// The pattern, where there is one.
    pub fn field(&self) -> Option<&Arc<Field>> {
        match &self.kind {
            PigmentKind::Colors { field, .. }
            | PigmentKind::Pigments { field, .. }
            | PigmentKind::Image { field, .. } => Some(field),
            PigmentKind::Color(_) | PigmentKind::UvMapped(_) => None,
        }
    }

    /// The pattern, where there is one, to be changed.
    pub fn field_mut(&mut self) -> Option<&mut Arc<Field>> {
        match &mut self.kind {
            PigmentKind::Colors { field, .. }
            | PigmentKind::Pigments { field, .. }
            | PigmentKind::Image { field, .. } => Some(field),
            PigmentKind::Color(_) | PigmentKind::UvMapped(_) => None,
        }
    }

    /// Turns filter into transmit everywhere, as layers of scenes up to version 3.1 have it
    /// (docs/spec/language.md 2.11).
    pub fn filter_to_transmit(&mut self) {
        let convert = |color: &mut Rgbft| {
            color.transmit += color.filter;
            color.filter = 0.0;
        };
        match &mut self.kind {
            PigmentKind::Color(color) => convert(color),
            PigmentKind::Colors { map: Some(map), .. } => {
                Arc::make_mut(map).entries.inside_mut().iter_mut().for_each(|(_, color)| convert(color));
            }
            PigmentKind::Pigments { map, .. } => {
                for (_, pigment) in Arc::make_mut(map).entries.inside_mut() {
                    Arc::make_mut(pigment).filter_to_transmit();
                }
            }
            PigmentKind::Image { map, .. } => {
                let map = Arc::make_mut(map);
                map.transmit.append(&mut map.filter);
            }
            PigmentKind::UvMapped(pigment) => Arc::make_mut(pigment).filter_to_transmit(),
            PigmentKind::Colors { map: None, .. } => {}
        }
    }

    /// Moves the pattern; plain colours have nothing to move, and the warps of a `uv_mapping`
    /// are ignored (docs/spec/patterns-textures.md 7.2).
    pub fn apply(&mut self, by: &Transform) {
        if let Some(field) = self.field_mut() {
            Arc::make_mut(field).apply(by);
        }
    }
}

impl Pattern {
    /// The colours of a pattern that was given none (docs/spec/patterns-textures.md 2.9).
    pub fn default_colors(&self) -> BlendMap<Rgbft> {
        const BLACK: [f32; 3] = [0.0, 0.0, 0.0];
        const WHITE: [f32; 3] = [1.0, 1.0, 1.0];
        const RED: [f32; 3] = [1.0, 0.0, 0.0];
        const GREEN: [f32; 3] = [0.0, 1.0, 0.0];
        const BLUE: [f32; 3] = [0.0, 0.0, 1.0];
        const YELLOW: [f32; 3] = [1.0, 1.0, 0.0];
        const CYAN: [f32; 3] = [0.0, 1.0, 1.0];
        const MAGENTA: [f32; 3] = [1.0, 0.0, 1.0];
        let rgb = |c: [f32; 3]| Rgbft::opaque(Rgb::from_array(c));
        let map = |entries: &[(f32, [f32; 3])]| {
            BlendMap::new(entries.iter().map(|&(at, c)| (at, rgb(c))).collect())
        };
        let list = |colors: &[[f32; 3]]| BlendMap::list(colors.iter().map(|&c| rgb(c)));
        match self {
            Self::Agate { .. } => map(&[
                (0.0, WHITE),
                (0.5, [0.95, 0.75, 0.5]),
                (0.5, [0.9, 0.7, 0.5]),
                (0.6, [0.9, 0.7, 0.4]),
                (0.6, [1.0, 0.7, 0.4]),
                (1.0, [0.6, 0.3, 0.0]),
            ]),
            Self::Bozo => {
                map(&[(0.4, WHITE), (0.4, GREEN), (0.6, GREEN), (0.6, BLUE), (0.8, BLUE), (0.8, RED)])
            }
            Self::Fractal(f) if f.kind == FractalKind::Mandel && f.julia.is_none() && f.exponent == 2 => {
                map(&[(0.001, BLACK), (0.001, CYAN), (0.012, YELLOW), (0.015, MAGENTA), (0.1, CYAN)])
            }
            Self::Marble => map(&[(0.0, [0.9, 0.8, 0.8]), (0.9, [0.9, 0.08, 0.08]), (0.9, BLACK)]),
            Self::Radial => map(&[(0.0, CYAN), (0.333, YELLOW), (0.666, MAGENTA), (1.0, CYAN)]),
            Self::Wood => map(&[(0.6, [0.666, 0.312, 0.2]), (0.6, [0.4, 0.1333, 0.066])]),
            Self::Checker | Self::Object(_) => list(&[BLUE, GREEN]),
            Self::Hexagon => list(&[BLUE, GREEN, RED]),
            Self::Brick { .. } => list(&[[0.5, 0.5, 0.5], [0.6, 0.15, 0.15]]),
            Self::Square => list(&[RED, GREEN, BLUE, YELLOW]),
            Self::Triangular | Self::Cubic => list(&[RED, GREEN, BLUE, YELLOW, CYAN, MAGENTA]),
            _ => map(&[(0.0, BLACK), (1.0, WHITE)]),
        }
    }
}
