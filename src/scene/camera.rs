//! The camera (docs/spec/camera-image.md 3 and 4).

use std::sync::Arc;

use super::{Normal, Pigment, shape::Mesh};
use crate::math::{DVec3, Transform};
use crate::source::Span;

/// A `camera` with its vectors assembled: `angle`, `look_at`, `sky` and the transforms have acted.
#[derive(Clone, Debug)]
pub struct Camera {
    /// Where the statement stands.
    pub span: Span,
    /// How pixels become rays.
    pub projection: Projection,
    /// The eye.
    pub location: DVec3,
    /// Towards the middle of the picture; its length matters for perspective.
    pub direction: DVec3,
    /// The picture's height.
    pub up: DVec3,
    /// The picture's width.
    pub right: DVec3,
    /// `angle` where written, in degrees: field of view of the wide-angle cameras.
    pub angle: Option<f64>,
    /// Focal blur, where `aperture` and `blur_samples` ask for it.
    pub blur: Option<FocalBlur>,
    /// Distance in focus.
    pub focal_distance: f64,
    /// Perturbs the rays.
    pub normal: Option<Arc<Normal>>,
}

/// How pixels become rays.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum Projection {
    Perspective,
    Orthographic,
    Fisheye,
    UltraWideAngle,
    Omnimax,
    Panoramic,
    /// Horizontal and vertical angle in degrees.
    Spherical {
        horizontal: f64,
        vertical: f64,
    },
    /// `cylinder 1` … `cylinder 4`.
    Cylinder(u32),
    /// `mesh_camera`.
    Mesh(Arc<MeshCamera>),
}

/// A `mesh_camera`.
#[derive(Clone, Debug)]
pub struct MeshCamera {
    /// Rays per pixel.
    pub rays_per_pixel: u32,
    /// Distribution type 0 … 3.
    pub distribution: u32,
    /// Largest distance, 0 for none (types 0 … 2), or the offset along the normal (type 3).
    pub max_distance: f64,
    /// The meshes rays start from, and where they are; `None` is the identity.
    pub meshes: Vec<(Arc<Mesh>, Option<Arc<Transform>>)>,
    /// Normals are interpolated.
    pub smooth: bool,
}

/// Focal blur.
#[derive(Clone, Debug)]
pub struct FocalBlur {
    /// Size of the lens.
    pub aperture: f64,
    /// Least samples per pixel.
    pub min_samples: u32,
    /// Most samples per pixel.
    pub max_samples: u32,
    /// In (0, 1).
    pub confidence: f64,
    /// Variance below which sampling stops.
    pub variance: f64,
    /// Shape of the lens over the unit square.
    pub bokeh: Option<Arc<Pigment>>,
}
