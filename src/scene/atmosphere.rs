//! What surrounds the objects (docs/spec/language.md 6.15, docs/spec/atmosphere-gi.md 1).

use std::sync::Arc;

use super::Pigment;
use super::pattern::Turbulence;
use super::pigment::BlendMap;
use crate::math::{DVec3, Rgb, Rgbft};
use crate::source::Span;

/// `fog { … }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Fog {
    /// Where the statement stands.
    pub span: Span,
    /// 1 is constant, 2 lies on the ground.
    pub kind: u32,
    /// Distance at which 1/e of the light is left.
    pub distance: f64,
    /// Colour; `filter` and `transmit` let the background through.
    pub color: Rgbft,
    /// Height over which ground fog thins out.
    pub altitude: f64,
    /// Height up to which ground fog is dense.
    pub offset: f64,
    /// Unit direction away from the ground.
    pub up: DVec3,
    /// Uneven thickness.
    pub turbulence: Option<Turbulence>,
    /// Strength of the turbulence along the ray.
    pub turb_depth: f32,
}

/// `rainbow { … }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Rainbow {
    /// Where the statement stands.
    pub span: Span,
    /// Direction of the light that makes it.
    pub direction: DVec3,
    /// Vertical direction.
    pub up: DVec3,
    /// Degrees between direction and bow.
    pub angle: f64,
    /// Degrees across the bow.
    pub width: f64,
    /// Distance of the bow.
    pub distance: f64,
    /// Random displacement.
    pub jitter: f64,
    /// Degrees of arc; 360 for no end.
    pub arc_angle: f64,
    /// Degrees after which the arc begins to fade; 360 for never.
    pub falloff_angle: f64,
    /// Colours from the inner edge to the outer.
    pub colors: Option<Arc<BlendMap<Rgbft>>>,
}

/// `sky_sphere { … }`.
#[derive(Clone, Debug)]
pub struct SkySphere {
    /// Where the statement stands.
    pub span: Span,
    /// Layers, the lowest first; evaluated at the ray's unit direction.
    pub pigments: Vec<Arc<Pigment>>,
    /// Multiplies everything.
    pub emission: Rgb,
}
