//! Cameras: one projection a file, all turning a place on the film into a ray
//! (docs/spec/camera-image.md 2 and 4).

mod bokeh;
pub mod cylinder;
pub mod fisheye;
pub mod focal_blur;
pub mod mesh_camera;
pub mod omnimax;
pub mod orthographic;
pub mod panoramic;
pub mod perspective;
pub mod spherical;
mod straight;
pub mod ultra_wide_angle;

pub use cylinder::Cylinder;
pub use fisheye::Fisheye;
pub use focal_blur::FocalBlur;
pub use mesh_camera::MeshCamera;
pub use omnimax::Omnimax;
pub use orthographic::Orthographic;
pub use panoramic::Panoramic;
pub use perspective::Perspective;
pub use spherical::Spherical;
pub use straight::Straight;
pub use ultra_wide_angle::UltraWideAngle;

use std::sync::Arc;

use super::Ray;
use super::accel::Points;
use super::sample::Sample;
use super::texture::Normal;
use crate::math::{DVec2, DVec3, Lanes};

/// A place on the film: `x` from -½ (left) to ½ (right), `y` from -½ (bottom) to ½ (top).
/// Samples of antialiasing may lie a little outside.
pub type Film = DVec2;

/// The place on the film of image coordinates in a picture of the given size; whole numbers are
/// the middles of pixels (docs/spec/camera-image.md 2).
#[inline]
pub fn film(x: f64, y: f64, width: u32, height: u32) -> Film {
    Film::new((x + 0.5) / f64::from(width) - 0.5, 0.5 - (y + 0.5) / f64::from(height))
}

/// The same of four.
#[inline(always)]
pub fn film_of_four(x: Lanes, y: Lanes, width: u32, height: u32) -> [Lanes; 2] {
    [(x + 0.5) / f64::from(width) - 0.5, -((y + 0.5) / f64::from(height)) + 0.5]
}

/// The eye.
#[derive(Debug)]
pub struct Camera {
    /// How the film becomes rays.
    pub projection: Projection,
    /// The lens, where pictures are blurred out of focus.
    pub blur: Option<FocalBlur>,
    /// Takes the place of projection and lens.
    pub mesh: Option<MeshCamera>,
    /// Bends the rays.
    pub normal: Option<Arc<Normal>>,
}

/// How the film becomes rays.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "named and described by the files")]
pub enum Projection {
    Perspective(Perspective),
    Orthographic(Orthographic),
    Fisheye(Fisheye),
    UltraWideAngle(UltraWideAngle),
    Omnimax(Omnimax),
    Panoramic(Panoramic),
    Spherical(Spherical),
    Cylinder(Cylinder),
}

/// The camera's vectors as the scene has them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The eye.
    pub location: DVec3,
    /// Along the picture's width.
    pub right: DVec3,
    /// Along the picture's height.
    pub up: DVec3,
    /// Towards the middle of the picture.
    pub direction: DVec3,
}

/// A ray of a projection before it is normalised, and the two parameters it came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// The ray, its direction of any length.
    pub ray: Ray,
    /// The projection's two parameters, where a camera `normal` is evaluated
    /// (docs/spec/camera-image.md 6).
    pub parameters: DVec2,
}

impl Frame {
    /// The same with unit right, up and direction, as the wide-angle projections want them.
    pub fn unit(&self) -> Self {
        Self {
            right: self.right.normalize_or_zero(),
            up: self.up.normalize_or_zero(),
            direction: self.direction.normalize_or_zero(),
            ..*self
        }
    }

    /// A ray from the eye in the direction `x right + y up + z direction`.
    #[inline]
    fn ray(&self, x: f64, y: f64, z: f64) -> Ray {
        Ray::new(self.location, x * self.right + y * self.up + z * self.direction)
    }
}

impl Projection {
    /// The ray through a place on the film; `None` where the picture has none, as outside the
    /// fisheye's circle.
    #[inline]
    pub fn project(&self, film: Film) -> Option<Projected> {
        match self {
            Self::Perspective(p) => Some(p.project(film)),
            Self::Orthographic(p) => Some(p.project(film)),
            Self::Fisheye(p) => p.project(film),
            Self::UltraWideAngle(p) => Some(p.project(film)),
            Self::Omnimax(p) => p.project(film),
            Self::Panoramic(p) => Some(p.project(film)),
            Self::Spherical(p) => Some(p.project(film)),
            Self::Cylinder(p) => Some(p.project(film)),
        }
    }

    /// The same, where rays through places near each other may travel together.
    pub fn straight(&self) -> Option<Straight<'_>> {
        match self {
            Self::Perspective(perspective) => Some(Straight::Perspective(perspective)),
            Self::Orthographic(orthographic) => Some(Straight::Orthographic(orthographic)),
            _ => None,
        }
    }

    /// Where all rays start; `None` where they don't start at one point.
    pub fn eye(&self) -> Option<DVec3> {
        match self {
            Self::Orthographic(_) => None,
            Self::Cylinder(p) => p.eye(),
            Self::Perspective(Perspective { frame }) | Self::Panoramic(Panoramic { frame }) => {
                Some(frame.location)
            }
            Self::Fisheye(p) => Some(p.eye()),
            Self::UltraWideAngle(p) => Some(p.eye()),
            Self::Omnimax(p) => Some(p.eye()),
            Self::Spherical(p) => Some(p.eye()),
        }
    }
}

impl Camera {
    /// The unit ray through a place on the film, without the lens.
    #[inline]
    pub fn ray(&self, film: Film) -> Option<Ray> {
        let Projected { ray, parameters } = match &self.projection {
            // Not by way of memory.
            Projection::Perspective(perspective) => perspective.project(film),
            other => other.project(film)?,
        };
        let mut ray = Ray::new(ray.origin, ray.direction.normalize_or_zero());
        self.bend(&mut ray, parameters);
        Some(ray)
    }

    /// Bends a unit ray by the camera's `normal`, which is evaluated at the projection's two parameters
    /// (docs/spec/camera-image.md 6).
    #[inline]
    pub fn bend(&self, ray: &mut Ray, parameters: DVec2) {
        if let Some(normal) = &self.normal {
            let sample = Sample::at(parameters.extend(0.0));
            ray.direction = normal.bend(&sample, ray.direction, false).normalize_or_zero();
        }
    }

    /// Where all rays start; `None` where they don't start at one point.
    pub fn eye(&self) -> Option<DVec3> {
        self.projection.eye().filter(|_| self.blur.is_none() && self.mesh.is_none())
    }

    /// Where they don't: at least three points around all places where rays start, those of samples included that are
    /// no more than `beside` off the film; `None` where such are not known.
    pub fn starts(&self, beside: f64) -> Option<Points> {
        if let Some(mesh) = &self.mesh {
            return Some(mesh.starts().corners().into_iter().collect());
        }
        if let Some(blur) = &self.blur {
            return Some(blur.extent().1.into_iter().collect());
        }
        let Projection::Orthographic(orthographic) = &self.projection else { return None };
        let edge = 0.5 + beside;
        let corners = [[-edge, -edge], [edge, -edge], [-edge, edge], [edge, edge]];
        Some(corners.into_iter().map(|corner| orthographic.origin(corner.into())).collect())
    }
}

#[cfg(test)]
mod tests;
