//! The colour of a layer.

use std::sync::Arc;

use super::Pigment;
use crate::math::Rgbft;
use crate::world::sample::Sample;

/// Where the colour of a layer comes from.
#[derive(Clone, Debug)]
pub enum Paint {
    /// One colour everywhere, in as little room as its five components take.
    Even([f32; 5]),
    /// A pigment, which others may share.
    Pigment(Arc<Pigment>),
}

impl Paint {
    /// The colour, where it is the same everywhere.
    #[inline]
    pub fn even(&self) -> Option<Rgbft> {
        match *self {
            Self::Even(color) => Some(Rgbft::new(color)),
            Self::Pigment(_) => None,
        }
    }

    /// The colour at `sample`; `None` outside a `once` image, where nothing was painted.
    #[inline]
    pub fn color(&self, sample: &Sample) -> Option<Rgbft> {
        match self {
            Self::Even(color) => Some(Rgbft::new(*color)),
            Self::Pigment(pigment) => pigment.color(sample),
        }
    }

    /// Whether nothing shines through anywhere (docs/spec/patterns-textures.md 7.3).
    pub fn is_opaque(&self) -> bool {
        match self {
            Self::Even(color) => Pigment::Color(Rgbft::new(*color)).is_opaque(),
            Self::Pigment(pigment) => pigment.is_opaque(),
        }
    }
}

impl From<Arc<Pigment>> for Paint {
    fn from(pigment: Arc<Pigment>) -> Self {
        match *pigment {
            Pigment::Color(color) => Self::Even(color.to_array()),
            _ => Self::Pigment(pigment),
        }
    }
}
